#!/usr/bin/python3
"""Builds the documentation site: lays out its sources, runs Doxygen and mkdocs, and checks the links between pages.

usage: build_site.py TAUT ROOT

The sources are those of the repository, in the same folders, so that every link is right in both places. Made here are
the command reference (from --help), the references of Python (from docstrings) and npm (from its types), the page of the
schema, and, where `./dev web` has built them, the playground and viewers of examples.
"""

import ast
import html.parser
import os
import re
import shutil
import subprocess
import sys
import urllib.parse

taut, root = os.path.realpath(sys.argv[1]), os.path.realpath(sys.argv[2])
source, site = os.path.join(root, "build/docs/source"), os.path.join(root, "build/docs/site")
api = os.path.join(root, "build/docs/api")

# What pages show or link to.
folders = ["docs", "examples", "include"]
pages = ["ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE", "CITATION.cff"]
viewers = ["lid", "parking_clips", "gears_thick_tooth", "jigsaw_caught", "combs", "spiral", "maze", "rotor_long_tooth"]


def run(*command, cwd=root):
    done = subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit("%s\nbuild_site: %s fails with exit code %d" % (done.stdout, command[0], done.returncode))
    return done.stdout


def write(path, text):
    with open(os.path.join(source, path), "w") as file:
        file.write(text)


def lay_out():
    shutil.rmtree(os.path.join(root, "build/docs"), ignore_errors=True)
    for folder in folders:
        shutil.copytree(os.path.join(root, folder), os.path.join(source, folder))
    for page in pages:
        shutil.copy(os.path.join(root, page), source)
    shutil.copy(os.path.join(root, "README.md"), os.path.join(source, "index.md"))
    for folder, _, names in os.walk(source):
        for name in names:
            if name.endswith(".md"):
                adapt(os.path.join(folder, name))


def adapt(path):
    """Links to folders, and to files that are no part of the site, become plain text."""
    folder = os.path.dirname(path)

    def link(match):
        target = match.group(2).split("#")[0]
        if re.match(r"[a-z]+:", match.group(2)) or not target:
            return match.group(0)
        there = os.path.normpath(os.path.join(folder, target))
        if there == os.path.join(source, "README.md"):
            return match.group(0).replace("README.md", "index.md")
        if os.path.isdir(there) and os.path.isfile(os.path.join(there, "README.md")):
            return match.group(0).replace(match.group(2), target.rstrip("/") + "/README.md")
        return match.group(0) if os.path.isfile(there) else match.group(1)

    with open(path) as file:
        text = file.read()
    text = re.sub(r"(?<!!)\[([^\]\[]*)\]\(([^) ]+)\)", link, text)
    with open(path, "w") as file:
        file.write(text)


def commands():
    """`taut --help`, and that of every command and every command within it."""
    def section(words, level):
        text = run(taut, *words, "--help")
        out = "%s taut %s\n\n```text\n%s\n```\n\n" % ("#" * level, " ".join(words), text.strip()) if words else \
            "# Commands\n\n```text\n%s\n```\n\n" % text.strip()
        inner = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
        names = re.findall(r"^  ([a-z]+) ", inner.group(1), re.MULTILINE) if inner else []
        names += ["completion", "man"] if not words else []
        return out + "".join(section(words + [name], 2 if not words else 3) for name in names)

    write("docs/commands.md", section([], 1))


def schema():
    text = run(taut, "schema")
    write("docs/schema.md", "# Schema of scenes\n\nWhat `taut schema` prints; as a file: "
          "[taut-scene-1.schema.json](taut-scene-1.schema.json).\n\n```json\n%s```\n" % text)


def docstring(node, title, level):
    """The docstring of a class or a function below a heading with its signature, and those of a class's public members."""
    text = ast.get_docstring(node)
    if not text:
        sys.exit("build_site: %s has no docstring, which is its page in the reference" % title)
    if isinstance(node, ast.ClassDef):
        out = "%s class %s\n\n%s\n\n" % ("#" * level, title, text)
        members = [m for m in node.body if isinstance(m, ast.FunctionDef) and not m.name.startswith("_")]
        return out + "".join(docstring(m, "%s.%s" % (title, m.name), level + 1) for m in members)
    shown = any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)
    result = " -> " + ast.unparse(node.returns) if node.returns else ""
    signature = title + (":" + result[3:] if shown else "(%s)%s" % (ast.unparse(node.args), result))
    return "%s %s\n\n```python\n%s\n```\n\n%s\n\n" % ("#" * level, title, signature, text)


def all_of(tree):
    """The names in __all__ of a module."""
    return next(ast.literal_eval(node.value) for node in tree.body
                if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__")


def python_reference():
    """What taut2d exports, with its docstrings, from the sources: the package need not be built. Every public name has one."""
    package = os.path.join(root, "python/taut2d")
    modules = {}
    for name in sorted(os.listdir(package)):
        if name.endswith(".py"):
            with open(os.path.join(package, name)) as file:
                modules[name[:-3]] = ast.parse(file.read())
    defined = {}
    for tree in modules.values():
        for node in tree.body:
            if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                defined.setdefault(node.name, node)
    main = modules["__init__"]
    # range() is no part of `import *`, which must leave Python's own alone.
    exported = all_of(main) + ["range"]
    for node in main.body:
        if isinstance(node, ast.AugAssign):
            exported += all_of(modules[node.value.value.id])
    missing = sorted(set(exported) - set(defined))
    if missing:
        sys.exit("build_site: taut2d exports what it does not define: " + ", ".join(missing))
    names = sorted(set(exported), key=str.lower)
    kinds = [("Functions", [n for n in names if isinstance(defined[n], ast.FunctionDef)]),
             ("Classes", [n for n in names if isinstance(defined[n], ast.ClassDef)])]
    text = "# Python reference\n\nEverything that `import taut2d` has. [From Python](python.md) is the guide.\n\n"
    for title, members in kinds:
        text += "## %s\n\n" % title + "".join(docstring(defined[name], name, 3) for name in members)
    write("docs/python-reference.md", text)


def npm_reference():
    """The package's types; of one that was not built (`./dev npm`), those of the answers only."""
    built, answers = (os.path.join(root, path) for path in ("build/npm/dist/taut.d.ts", "packaging/npm/src/answers.d.ts"))
    with open(built if os.path.isfile(built) else answers) as file:
        types = file.read()
    write("docs/npm-reference.md", "# npm reference\n\nThe types of the package. [The npm package](npm.md) is the guide.\n\n"
          "```ts\n%s```\n" % types)


def playground():
    page = os.path.join(root, "build/web/index.html")
    if os.path.isfile(page):
        shutil.copy(page, os.path.join(source, "docs/playground.html"))
        text = "Open the [playground](playground.html): scenes to edit and to look at, computed in your browser.\n"
    else:
        text = "This site was built without the playground: `./dev web` makes it.\n"
    write("docs/playground.md", "# Playground\n\n" + text)


def gallery():
    """Adds the pages of the viewer, if there is one."""
    made = []
    for name in viewers:
        page = os.path.join(source, "docs", "view-%s.html" % name)
        done = subprocess.run([taut, "view", "examples/%s.json" % name, "-o", page], cwd=root, capture_output=True)
        if done.returncode == 0:
            made.append(name)
    if made:
        with open(os.path.join(source, "docs/gallery.md"), "a") as file:
            file.write("\n## To step through\n\nThese pages compute in your browser, by the same code.\n\n")
            file.writelines("* [%s](view-%s.html)\n" % (name.replace("_", " "), name) for name in made)
    else:
        print("build_site: no viewer's page (./dev web builds it): the gallery has pictures only")


def doxygen():
    """What is public must be documented, but for members of structs whose names say it all."""
    output = run("doxygen", os.path.join(root, "docs/Doxyfile"))
    obvious = re.compile(r"Member .* \((variable|friend|enumvalue)\) of .* is not documented")
    warnings = [line for line in output.split("\n") if "warning:" in line and not obvious.search(line)]
    if warnings:
        sys.exit("\n".join(warnings) + "\nbuild_site: the public headers are not documented")
    write("docs/api.md", "# C++ API\n\n[The reference of all headers](api/index.html), made by Doxygen from "
          "[include/taut](../include/taut/taut.hpp). [From C++](cpp.md) is the way in.\n")
    shutil.copytree(os.path.join(api, "html"), os.path.join(source, "docs/api"))


def mkdocs():
    """Pages that are not there are left out of the navigation."""
    with open(os.path.join(root, "mkdocs.yml")) as file:
        lines = file.readlines()

    def there(line):
        page = re.match(r" +- .*: (\S+\.md)$", line)
        return not page or os.path.exists(os.path.join(source, page.group(1)))

    config = os.path.join(root, "build/docs/mkdocs.yml")
    with open(config, "w") as file:
        for line in lines:
            if there(line):
                file.write(re.sub(r"^(docs_dir|site_dir): build/docs/", r"\1: ", line))
    run("mkdocs", "build", "--strict", "--quiet", "--config-file", config)


class Links(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("href", "src") and value:
                self.links.append(value)
            if key in ("id", "name") and value:
                self.anchors.add(value)


def parsed(path, cache={}):
    if path not in cache:
        cache[path] = Links()
        with open(path, encoding="utf-8", errors="replace") as file:
            cache[path].feed(file.read())
    return cache[path]


def check_links():
    """Every link from page to page leads to a file, and to a place in it."""
    broken, count = [], 0
    for folder, _, names in os.walk(site):
        if folder.startswith(os.path.join(site, "docs/api")):
            continue  # Doxygen has checked its own
        for name in names:
            if not name.endswith(".html") or name == "404.html" or name.startswith("view-"):
                continue
            for link in parsed(os.path.join(folder, name)).links:
                url = urllib.parse.urlparse(link)
                if url.scheme or url.netloc:
                    continue
                count += 1
                path = os.path.normpath(os.path.join(folder, urllib.parse.unquote(url.path))) if url.path else \
                    os.path.join(folder, name)
                if os.path.isdir(path):
                    path = os.path.join(path, "index.html")
                wanted = urllib.parse.unquote(url.fragment)
                if not os.path.isfile(path):
                    broken.append("%s: %s" % (name, link))
                elif wanted and path.endswith(".html") and wanted not in parsed(path).anchors:
                    broken.append("%s: %s: no such place" % (name, link))
    if broken or count < 100:
        sys.exit("build_site: broken links (of %d):\n%s" % (count, "\n".join(sorted(set(broken)))))
    return count


lay_out()
commands()
schema()
python_reference()
npm_reference()
playground()
gallery()
doxygen()
mkdocs()
print("build_site: %s/index.html, %d links checked" % (os.path.relpath(site, root), check_links()))
