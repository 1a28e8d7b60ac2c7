# Makes the documentation: copies the pages of docs/, runs their blocks so that their pictures are there,
# writes the reference beside them, and lets Sphinx make one site of all, with warnings as errors.
#
# usage: pages.py SOURCE BUILD OUT; BUILD: a build folder with sf in it. OUT/html is the site.

import glob
import json
import os
import re
import shutil
import subprocess
import sys

import blocks
import c_reference
import cli_reference
import figures
import performance
import python_reference
import rust_reference

MADE = re.compile(r"\]\(made/([\w.-]+)\)")
# For people who work on libsf, and not of its site.
NOT_PAGES = {"make", "pictures"}


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def write(text, *path):
    os.makedirs(os.path.dirname(os.path.join(*path)), exist_ok=True)
    with open(os.path.join(*path), "w", encoding="utf-8") as file:
        file.write(text)


def names(source):
    """The pages that are written by hand, by their place in docs/."""
    docs = os.path.join(source, "docs")
    found = glob.glob(os.path.join(docs, "**", "*.md"), recursive=True)
    return sorted(os.path.relpath(p, docs).replace(os.sep, "/") for p in found)


def run(source, build, folder, page, text):
    """Runs the blocks of a page that shows pictures which they make."""
    runner = blocks.Runner(source, build, os.path.join(folder, "run", page.removesuffix(".md")))
    for block in blocks.find(page, text):
        wrong = runner.run(block)
        if wrong and wrong.startswith("skip: "):
            runner.excuse(block)
        elif wrong:
            sys.exit(f"docs/{block.place()}: {wrong}")


def pictures(folder, page, text):
    """Puts what the blocks of a page drew where it looks for it. Returns the page, without pictures that this build
    cannot make."""
    place = os.path.join(folder, "source", os.path.dirname(page), "made")
    ran = os.path.join(folder, "run", page.removesuffix(".md"))
    for name in sorted(set(MADE.findall(text))):
        made = os.path.join(ran, name)
        if not os.path.exists(made) and blocks.excused(ran, name):
            text = re.sub(r"!\[[^\]]*\]\(made/" + re.escape(name) + r"\)", "*(This build cannot make the picture.)*", text)
            continue
        if not os.path.exists(made):
            sys.exit(f"docs/{page} shows {name}, which none of its blocks makes")
        os.makedirs(place, exist_ok=True)
        shutil.copy(made, place)
    return text


def reference(source, build, place):
    api = json.loads(read(source, "bindings", "api", "api.json"))
    for name, text in c_reference.pages(api):
        write(text, place, "reference", "c", name + ".rst")
    for name, text in python_reference.pages(source, api):
        write(text, place, "reference", "python", name + ".rst")
    write(rust_reference.page(api, os.path.join(source, "bindings", "rust", "libsf", "src")), place, "reference", "rust.rst")
    more = [("sf-verify", os.path.join(build, "demo", "verify", "sf-verify")),
            ("sf-chip", os.path.join(build, "demo", "firmware", "sf-chip")),
            ("sf-fill", os.path.join(build, "demo", "fill", "sf-fill")),
            ("sf-tetgen", os.path.join(build, "demo", "fill", "sf-tetgen"))]
    write(cli_reference.page(os.path.join(build, "demo", "sf", "sf"), [m for m in more if os.path.exists(m[1])]),
          place, "reference", "cli.rst")
    write(performance.page(os.path.join(source, "docs", "performance.json")), place, "performance.rst")


def make(source, build, out):
    """The site in OUT/html, from blocks that were run in OUT/run. Returns whether Sphinx had nothing to say."""
    place = os.path.join(out, "source")
    shutil.rmtree(place, ignore_errors=True)
    for page in names(source):
        text = read(source, "docs", page)
        write(pictures(out, page, text), place, page)
    shutil.copytree(os.path.join(source, "docs", "pictures"), os.path.join(place, "pictures"),
                    ignore=shutil.ignore_patterns("*.sh", "*.input"))
    for schema in glob.glob(os.path.join(source, "docs", "*.schema.json")):
        shutil.copy(schema, place)
    for name in ("conf.py", "site.css"):
        shutil.copy(os.path.join(source, "docs", "make", name), place)
    version = re.search(r"version: '([^']+)'", read(source, "meson.build"))
    write(version.group(1) + "\n", place, "version.txt")
    figures.draw(os.path.join(place, "figures"))
    reference(source, build, place)
    python = os.environ.get("SPHINX_PYTHON", sys.executable)
    return subprocess.run([python, "-m", "sphinx", "-b", "html", "-W", "--keep-going", "-q",
                           "-d", os.path.join(out, "doctrees"), place, os.path.join(out, "html")],
                          stdout=sys.stderr).returncode == 0


def main():
    source, build, out = (os.path.abspath(p) for p in sys.argv[1:4])
    shutil.rmtree(os.path.join(out, "run"), ignore_errors=True)
    for page in names(source):
        text = read(source, "docs", page)
        if MADE.search(text):
            run(source, build, out, page, text)
    return 0 if make(source, build, out) else 1


if __name__ == "__main__":
    sys.exit(main())
