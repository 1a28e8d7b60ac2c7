# The reference of Python, a page for each module, from the sources of the package: signatures with their
# types, docstrings, and which function of C does the work, whose comment says the rest. The package need
# not be built, nor its libraries installed, for its reference to be there.

import ast
import os

import words

# Modules of the package's surface, in the order in which one meets them.
MODULES = ["voxel", "layers", "support", "places", "paths", "certificates", "mesh", "stacks", "balance", "carving",
           "bending", "standing", "cages", "refining", "limits", "halftoning", "mixing", "sculpting", "sessions",
           "batch", "plot", "errors"]


def exported(package):
    """The names that `import libsf` brings."""
    for node in ast.parse(read(package, "__init__.py")).body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            return set(ast.literal_eval(node.value))
    return set()


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


def in_c(node):
    """The functions of C that @documented names."""
    return [a.value for d in node.decorator_list if isinstance(d, ast.Call) and getattr(d.func, "id", "") == "documented"
            for a in d.args if isinstance(a, ast.Constant)]


def has(node, name):
    return any(getattr(d, "id", getattr(d, "attr", "")) == name for d in node.decorator_list)


def body_lines(node, indent):
    lines = words.paragraphs(ast.get_docstring(node) or "", indent)
    # A docstring's example stays as it is.
    functions = in_c(node) if hasattr(node, "decorator_list") else []
    if functions:
        links = ", ".join(f":c:func:`{f}`" if f in words.FUNCTIONS else f":c:type:`{f}`" if f in words.TYPES
                          else f"``{f}``" for f in functions)
        lines += [f"{indent}In C: {links}.", ""]
    return lines


def arguments(node, is_method):
    inside = ast.unparse(node.args)
    if is_method:
        inside = inside.partition(",")[2].strip() if "," in inside else ""
    back = f" -> {ast.unparse(node.returns)}" if node.returns is not None else ""
    return f"({inside}){back}"


def function_lines(node, indent="", kind="function", is_method=False):
    lines = [f"{indent}.. py:{kind}:: {node.name}{arguments(node, is_method)}"]
    if has(node, "classmethod"):
        lines.append(f"{indent}   :classmethod:")
    if has(node, "staticmethod"):
        lines.append(f"{indent}   :staticmethod:")
    return lines + [""] + body_lines(node, indent + "   ")


def field_lines(node, indent):
    name, kind = node.target.id, ast.unparse(node.annotation)
    lines = [f"{indent}.. py:attribute:: {name}", f"{indent}   :type: {kind}"]
    if node.value is not None and not isinstance(node.value, ast.Call):
        lines.append(f"{indent}   :value: {ast.unparse(node.value)}")
    return lines + [""]


def class_lines(node):
    make = next((n for n in node.body if isinstance(n, ast.FunctionDef) and n.name == "__init__"), None)
    lines = [f".. py:class:: {node.name}" + (arguments(make, True).replace(" -> None", "") if make else ""), ""]
    lines += body_lines(node, "   ")
    if make is not None:
        lines += body_lines(make, "   ")
    for part in node.body:
        if isinstance(part, ast.AnnAssign) and not part.target.id.startswith("_"):
            lines += field_lines(part, "   ")
        elif isinstance(part, ast.FunctionDef) and not part.name.startswith("_"):
            if has(part, "property"):
                lines += [f"   .. py:property:: {part.name}"]
                lines += [f"      :type: {ast.unparse(part.returns)}"] if part.returns else []
                lines += [""] + body_lines(part, "      ")
            elif not has(part, "overload") and not has(part, "setter"):
                static = has(part, "staticmethod")
                lines += function_lines(part, "   ", "method", not static)
    return lines


def page(package, module, names):
    tree = ast.parse(read(package, module + ".py"))
    whole = "libsf." + module if module in ("batch", "plot") else "libsf"
    public = [n for n in tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef)) and not n.name.startswith("_")
              and (n.name in names or whole != "libsf")]
    lines = words.title(module, "=") + words.paragraphs(ast.get_docstring(tree) or "")
    lines += [f".. py:currentmodule:: {whole}", ""]
    seen = set()
    for node in public:
        if has(node, "overload") or node.name in seen:
            continue
        seen.add(node.name)
        lines += class_lines(node) if isinstance(node, ast.ClassDef) else function_lines(node)
    return lines, seen


def enum_page(api, names):
    """The enumerations, which the package makes of the interface when it is built."""
    lines = words.title("enumerations", "=") + [
        "Numbers with names, the same as in C. Wherever one is asked for, its name as a text will do.", "",
        ".. py:currentmodule:: libsf", ""]
    seen = set()
    for enum in api["enums"]:
        name = "".join(p.capitalize() for p in enum["name"].removeprefix("sf_").split("_"))
        if name not in names:
            continue
        seen.add(name)
        prefix = "SF_" + enum["name"].removeprefix("sf_").upper() + "_"
        lines += [f".. py:class:: {name}", ""] + words.paragraphs(enum["doc"], "   ")
        for v in [v for v in enum["values"] if not v["name"].endswith("_COUNT")]:
            short = v["name"].removeprefix(prefix).removeprefix("SF_")
            lines += [f"   .. py:attribute:: {short}", "", "      " + words.inline(v["doc"]), ""]
    return lines, seen


def pages(source, api):
    package = os.path.join(source, "bindings", "python", "libsf")
    names = exported(package)
    made, covered = {}, set()
    for module in [m for m in MODULES if os.path.exists(os.path.join(package, m + ".py"))]:
        lines, seen = page(package, module, names)
        made[module] = lines
        covered |= seen
    lines, seen = enum_page(api, names - covered)
    made["enumerations"] = lines
    rest = sorted(names - covered - seen)
    if rest:
        made["others"] = words.title("others", "=") + [f"* ``{name}``" for name in rest] + [""]
    index = words.title("Python", "=") + [
        f"``import libsf`` brings {len(names)} names; ``libsf.batch`` and ``libsf.plot`` are modules of their own. "
        "How to build it, and what it is like: :doc:`/python`.", "",
        ".. toctree::", "   :maxdepth: 1", ""] + [f"   {m}" for m in made]
    yield "index", "\n".join(index) + "\n"
    for module, lines in made.items():
        yield module, "\n".join(lines) + "\n"
