#!/usr/bin/python3
"""The recipes of packages, as far as they can be held against the project without their tools: versions, options of
CMake, files and targets that they name. usage: recipes_test.py ROOT"""
import ast
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(sys.argv[1])
recipes = root / "packaging"
cmake = (root / "CMakeLists.txt").read_text()
version = re.search(r"project\(taut VERSION ([\d.]+)", cmake)[1]
failures = []


def expect(condition, what):
    if not condition:
        failures.append(what)


vcpkg = json.loads((recipes / "vcpkg/vcpkg.json").read_text())
conan = (recipes / "conan/conanfile.py").read_text()
conda = (recipes / "conda/meta.yaml").read_text()
conda_python = (recipes / "conda-python/meta.yaml").read_text()
npm = json.loads((recipes / "npm/package.json").read_text())
port = (recipes / "vcpkg/portfile.cmake").read_text()

expect(vcpkg["version"] == version, f"vcpkg.json is not of version {version}")
expect(npm["version"] == version, f"package.json is not of version {version}")
for name, text in (("conda", conda), ("conda-python", conda_python)):
    expect(f'set version = "{version}"' in text, f"{name}/meta.yaml is not of version {version}")
fields = {}
for node in ast.walk(ast.parse(conan)):
    if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and isinstance(node.value, ast.Constant):
        fields[node.targets[0].id] = node.value.value
expect(fields.get("version") == version, f"conanfile.py is not of version {version}")

options = set(re.findall(r"^option\((TAUT_\w+)", cmake, re.M))
for name, text in (("portfile.cmake", port), ("conanfile.py", conan), ("meta.yaml", conda)):
    for option in set(re.findall(r"TAUT_\w+", text)):
        expect(option in options, f"{name} sets {option}, which is no option")

# What the sources include of others is what the recipes ask for.
others = set()
for file in (root / "src").rglob("*.?pp"):
    others |= set(re.findall(r"#include <(boost|fmt|nlohmann)/", file.read_text()))
wanted = {"boost": ("boost-multiprecision", "boost/", "libboost-headers"), "fmt": ("fmt", "fmt/", "fmt"),
          "nlohmann": ("nlohmann-json", "nlohmann_json/", "nlohmann_json")}
for name in others:
    in_vcpkg, in_conan, in_conda = wanted[name]
    expect(in_vcpkg in vcpkg["dependencies"], f"vcpkg.json lacks {in_vcpkg}")
    expect(f'requires("{in_conan}' in conan, f"conanfile.py lacks {in_conan}")
    for text in (conda, conda_python):
        expect(f"- {in_conda}\n" in text, f"meta.yaml lacks {in_conda}")
expect(len(others) == 3, f"the sources include {sorted(others)}")
for pattern in re.findall(r'"((?:\w+/\*|[A-Z]\w+(?:\.txt)?))"', conan.split("def export_sources")[1].split("def layout")[0]):
    expect((root / pattern.split("/")[0]).exists(), f"conanfile.py names {pattern}")

python = (root / "pyproject.toml").read_text()
expect(f'version = "{version}"' in python, f"pyproject.toml is not of version {version}")
for requirement in re.findall(r'"([^"]+)"', re.search(r"^requires = \[(.*)\]$", python, re.M)[1]):
    expect(f"- {requirement.replace('>=', ' >=')}\n" in conda_python, f"conda-python/meta.yaml lacks {requirement}")
expect(any("CLI/" in file.read_text() for file in (root / "apps").rglob("*.?pp")) == ("- cli11\n" in conda),
       "meta.yaml and the programs disagree about CLI11")

# The lines of conda's script, on a copy, without building: options are known, and targets are there.
script = [shlex.split(line) for line in re.findall(r"^    - (cmake .*)$", conda, re.M)]
# What the recipe for Conan exports configures by itself.
exported = re.findall(r'"([\w./*]+)"', conan.split("for pattern in (")[1].split("):")[0])
fixed = re.findall(r"-DTAUT_\w+=\w+", port)
feature = re.findall(r"FEATURES tools (TAUT_\w+)", port)


def configured(source, build, options, what):
    run = subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", *options], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True)
    expect(run.returncode == 0, f"{what} does not configure: {run.stdout[-800:]}")
    expect("Manually-specified variables were not used" not in run.stdout, f"{what}: options that nothing uses")
    targets = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], stdout=subprocess.PIPE, text=True)
    return {line.split(":")[0] for line in targets.stdout.splitlines()}


if shutil.which("cmake") and shutil.which("ninja"):
    with tempfile.TemporaryDirectory() as folder:
        alone = Path(folder, "exported")
        for pattern in exported:
            if pattern.endswith("/*"):
                shutil.copytree(root / pattern[:-2], alone / pattern[:-2])
            else:
                alone.mkdir(exist_ok=True)
                shutil.copy(root / pattern, alone / pattern)
        chosen = [f"-D{name}=OFF" for name in re.findall(r'"(TAUT_\w+)"', conan)]
        expect(chosen and fixed and feature, "conanfile.py and portfile.cmake set no options")
        expect("taut" in configured(alone, Path(folder, "conan"), chosen, "conanfile.py"), "conanfile.py: no target taut")
        for value in ("OFF", "ON"):
            options = fixed + [f"-D{name}={value}" for name in feature]
            targets = configured(root, Path(folder, "port" + value), options, "portfile.cmake")
            tools = {"taut_cli", "taut_verify"} & targets
            expect("taut" in targets and len(tools) == (2 if value == "ON" else 0), f"portfile.cmake: {sorted(tools)}")
        options = [word for word in script[0] if word.startswith("-DTAUT_")]
        targets = configured(root, Path(folder, "conda"), options, "meta.yaml")
        wanted = script[1][script[1].index("--target") + 1:]
        expect(wanted and targets.issuperset(wanted), f"meta.yaml builds {wanted}: some are no targets")
else:
    print("without cmake and ninja the recipes are not configured")

for failure in failures:
    print("FAILED:", failure)
print("all well" if not failures else f"{len(failures)} failures")
sys.exit(1 if failures else 0)
