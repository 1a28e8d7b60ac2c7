# Why: a page that shows a command which does not work is worse than none. Every block of code of docs/ is
# run in the order of its page; one that cannot be says why, in the page. No block hides by being
# indented, and no page shows a picture that nobody makes. Then the site is made of them, as ./dev docs
# does: Sphinx must have nothing to say, and no link within the site may lead nowhere.
#
# usage: docs.py SOURCE BUILD FOLDER HAS_SPHINX [PAGE...]; speaks TAP.

import html.parser
import os
import shutil
import sys
import urllib.parse

SOURCE, BUILD, FOLDER = (os.path.abspath(p) for p in sys.argv[1:4])
HAS_SPHINX, ASKED = sys.argv[4] == "yes", sys.argv[5:]
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(SOURCE, "docs", "make"))

import blocks  # noqa: E402
import pages  # noqa: E402

NUMBER = [0, 0]


def ok(good, what, why=""):
    NUMBER[0] += 1
    NUMBER[1] += not good
    print(f"{'ok' if good else 'not ok'} {NUMBER[0]} - {what}", flush=True)
    for line in why.splitlines()[:30] if not good else []:
        print("#   " + line, flush=True)


def skip(what, why):
    NUMBER[0] += 1
    print(f"ok {NUMBER[0]} - {what} # SKIP {' '.join(why.split())}", flush=True)


def try_page(page, text):
    stray = blocks.stray(text)
    ok(not stray, f"{page} has no indented blocks", f"lines {stray}")
    runner = blocks.Runner(SOURCE, BUILD, os.path.join(FOLDER, "run", page.removesuffix(".md")))
    for block in blocks.find(page, text):
        what = f"{block.place()}, {block.language}"
        wrong = runner.run(block)
        if wrong and wrong.startswith("skip: "):
            skip(what, wrong.removeprefix("skip: "))
            runner.excuse(block)
        else:
            ok(not wrong, what, wrong or "")
    missing = [p for p in pages.MADE.findall(text) if not os.path.exists(os.path.join(runner.folder, p))
               and not blocks.excused(runner.folder, p)]
    ok(not missing, f"{page} makes the pictures that it shows", " ".join(missing))


class Page(html.parser.HTMLParser):
    """What a page of the site links to, and the places in it that can be linked to."""

    def __init__(self, path):
        super().__init__()
        self.links, self.places = [], set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (name == "name" and tag == "a"):
                self.places.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def dead_links(site):
    found = {}
    for folder, _, files in os.walk(site):
        for name in files:
            if name.endswith(".html"):
                path = os.path.join(folder, name)
                found[path] = Page(path)
    bad = []
    for path, page in found.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = os.path.normpath(os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path)))
            target = path if not parts.path else target
            if not os.path.exists(target):
                bad.append(f"{os.path.relpath(path, site)}: {link} is not there")
            elif parts.fragment and target in found and urllib.parse.unquote(parts.fragment) not in found[target].places:
                bad.append(f"{os.path.relpath(path, site)}: {link} has no such place")
    return len(found), bad


def try_site():
    if not HAS_SPHINX:
        skip("the site is made without a warning", "Sphinx, myst-parser or furo is not installed")
        skip("no link within it leads nowhere", "there is no site")
        return
    ok(pages.make(SOURCE, BUILD, FOLDER), "the site is made without a warning", "Sphinx has said why")
    count, bad = dead_links(os.path.join(FOLDER, "html"))
    ok(count > 60 and not bad, f"no link within its {count} pages leads nowhere", "\n".join(bad))


def main():
    shutil.rmtree(os.path.join(FOLDER, "run"), ignore_errors=True)
    for page in ASKED or pages.names(SOURCE):
        try_page(page, pages.read(SOURCE, "docs", page))
    if not ASKED:
        try_site()
    print(f"1..{NUMBER[0]}")
    sys.exit(NUMBER[1] > 0)


main()
