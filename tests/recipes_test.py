#!/usr/bin/python3
"""The recipes of packages, as far as they can be held against the project without their tools: versions, options of
CMake, files and targets that they name. usage: recipes_test.py ROOT"""
import ast
import json
import re
import sys
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
npm = json.loads((recipes / "npm/package.json").read_text())
port = (recipes / "vcpkg/portfile.cmake").read_text()

expect(vcpkg["version"] == version, f"vcpkg.json is not of version {version}")
expect(npm["version"] == version, f"package.json is not of version {version}")
expect(f'set version = "{version}"' in conda, f"meta.yaml is not of version {version}")
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
    expect(f"- {in_conda}\n" in conda, f"meta.yaml lacks {in_conda}")
expect(len(others) == 3, f"the sources include {sorted(others)}")
for pattern in re.findall(r'"((?:\w+/\*|[A-Z]\w+(?:\.txt)?))"', conan.split("def export_sources")[1].split("def layout")[0]):
    expect((root / pattern.split("/")[0]).exists(), f"conanfile.py names {pattern}")

for failure in failures:
    print("FAILED:", failure)
print("all well" if not failures else f"{len(failures)} failures")
sys.exit(1 if failures else 0)
