"""The package as pip builds it: a source distribution with what it needs and no more, and wheels of it, without an index.

Wheels that pip would fetch are those of Debian: of setuptools and wheel there are files, of pybind11 one is packed here."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

import pytest

root = pathlib.Path(__file__).resolve().parents[2]
debian_wheels = pathlib.Path("/usr/share/python-wheels")
debian_pybind11 = pathlib.Path("/usr/lib/python3/dist-packages")

pytest.importorskip("build")
if not list(debian_wheels.glob("wheel-*.whl")) or not (debian_pybind11 / "pybind11").exists():
    pytest.skip("Debian's wheels, or its pybind11, are not installed", allow_module_level=True)


def run(*command, cwd=None, **environment):
    """What it prints. Files that were compiled before, elsewhere, ccache knows again."""
    known = {"CXX": "g++", "CCACHE_NOHASHDIR": "1", "CCACHE_SLOPPINESS": "pch_defines,time_macros", "PIP_NO_INDEX": "1",
             "PIP_CONFIG_FILE": os.devnull, "CMAKE_ARGS": "-DTAUT_WERROR=ON"}
    if shutil.which("ccache"):
        known["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    done = subprocess.run([str(word) for word in command], cwd=cwd, env={**os.environ, **known, **environment},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, done.stdout[-4000:]
    return done.stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("packaging")


@pytest.fixture(scope="module")
def sdist(folder):
    # Of a copy: setuptools leaves files in the folder.
    copy = folder / "copy"
    for name in tracked():
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / name, copy / name)
    run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "-o", folder, copy)
    found, = folder.glob("taut2d-*.tar.gz")
    return found


@pytest.fixture(scope="module")
def source(sdist, folder):
    with tarfile.open(sdist) as archive:
        archive.extractall(folder / "unpacked")
    found, = (folder / "unpacked").iterdir()
    return found


def tracked():
    """The files of the project, also those that no commit has yet."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=root,
                            stdout=subprocess.PIPE, text=True)
    if listed.returncode != 0:
        pytest.skip("this is no clone")
    return [name for name in listed.stdout.splitlines() if (root / name).is_file()]


def environment(path, *options):
    run("/usr/bin/python3", "-m", "venv", *options, path)
    return path / "bin/python"


def first_program():
    """That of the package's page, and what it says that is printed."""
    program = re.search(r"```python\n(.*?)```", (root / "python/README.md").read_text(), re.S)[1]
    return program, re.search(r"# (contact .*)", program)[1]


def test_the_source_distribution_has_what_it_needs(sdist):
    with tarfile.open(sdist) as archive:
        names = {member.name.split("/", 1)[1] for member in archive if member.isfile()}
    needed = ("CMakeLists.txt", "CMakePresets.json", "LICENSE", "MANIFEST.in", "pyproject.toml", "setup.py", "apps/import/",
              "include/", "python/CMakeLists.txt", "python/README.md", "python/src/", "python/taut2d/", "src/",
              "cmake/layers.cmake", "cmake/system_headers.cmake")
    expected = {name for name in tracked() if name.startswith(needed)}
    written = {"PKG-INFO", "setup.cfg"} | {name for name in names if name.startswith("python/taut2d.egg-info/")}
    assert names - written == expected
    assert sdist.stat().st_size < 2e6


def test_pip_builds_it_in_an_environment_of_its_own(source, folder):
    """As with an index: what pyproject.toml requires is fetched, from a folder."""
    wheels = folder / "wheels"
    packed = folder / "pybind11"
    shutil.copytree(debian_pybind11 / "pybind11", packed / "pybind11", ignore=shutil.ignore_patterns("__pycache__"))
    info, = debian_pybind11.glob("pybind11-*.dist-info")
    shutil.copytree(info, packed / info.name)
    wheels.mkdir()
    for wheel in debian_wheels.glob("*.whl"):
        shutil.copy(wheel, wheels)
    run("/usr/bin/python3", "-m", "wheel", "pack", packed, "-d", wheels)

    plain = environment(folder / "plain")
    run(plain, "-m", "pip", "wheel", "--find-links", wheels, "-w", folder / "built", source,
        CCACHE_BASEDIR=str(source))
    built, = (folder / "built").glob("taut2d-*.whl")
    run(plain, "-m", "pip", "install", built)
    program, printed = first_program()
    assert run(plain, "-c", program, cwd=folder) == printed + "\n"
    assert "README" not in run(plain, "-m", "pip", "show", "-f", "taut2d")


def test_pip_installs_it_from_a_folder_with_debians_packages(source, folder):
    """Without an index: what pyproject.toml requires is the system's. Editable, so that what is edited is imported."""
    seeing = environment(folder / "seeing", "--system-site-packages")
    run(seeing, "-m", "pip", "install", "--no-build-isolation", "-e", source, CCACHE_BASEDIR=str(source))
    program, printed = first_program()
    assert run(seeing, "-c", program, cwd=folder) == printed + "\n"
    with open(source / "python/taut2d/__init__.py", "a") as file:
        file.write("\nedited = True\n")
    assert run(seeing, "-c", "import taut2d; print(taut2d.edited)", cwd=folder) == "True\n"
