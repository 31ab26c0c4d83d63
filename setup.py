"""Builds the compiled part with CMake; pyproject.toml has the rest.

CMAKE_ARGS, as in other packages, holds further options for CMake. The folder build/ of the project keeps what was
compiled, so that only changes are compiled the next time.
"""

import glob
import os
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = os.path.dirname(os.path.abspath(__file__))


# What the library includes of others, and Debian's packages that have it.
headers = {"boost/multiprecision/cpp_int.hpp": "libboost-dev", "nlohmann/json.hpp": "nlohmann-json3-dev",
           "fmt/format.h": "libfmt-dev"}


def flags(name):
    return shlex.split(os.environ.get(name, ""))


def missing_packages():
    """Debian's names of what the compiler or this system lacks."""
    missing = [] if shutil.which("cmake") else ["cmake"]
    compiler = flags("CXX") or ["c++"]
    if not shutil.which(compiler[0]):
        return missing + ["g++"]
    lines = [f"#if !__has_include(<{header}>)\nmissing {package}\n#endif" for header, package in headers.items()]
    found = subprocess.run([*compiler, *flags("CPPFLAGS"), *flags("CXXFLAGS"), "-x", "c++", "-E", "-P", "-"],
                           input="\n".join(lines) + "\n", stdout=subprocess.PIPE, text=True)
    return missing + [line.split()[1] for line in found.stdout.splitlines() if line.startswith("missing ")]


def require_tools():
    """Says at once what is missing, instead of CMake's pages about the first thing that is."""
    missing = missing_packages()
    # Where to look may be among the options for CMake.
    if missing and "CMAKE_ARGS" not in os.environ:
        raise SystemExit("taut2d is compiled here, and lacks (by Debian's names) " + ", ".join(missing) +
                         ". On Debian: apt install g++ cmake ninja-build libboost-dev nlohmann-json3-dev libfmt-dev "
                         "pybind11-dev python3-dev")


def pybind11_options():
    """That of the environment, if it has one; else CMake finds the system's."""
    try:
        import pybind11
        return ["-Dpybind11_DIR=" + pybind11.get_cmake_dir()]
    except ImportError:
        return []


class CMakeModule(build_ext):
    def build_extension(self, extension):
        require_tools()
        build = os.path.join(root, "build", "pip-" + sys.implementation.cache_tag)
        package = os.path.join(build, "python", "taut2d")
        # As the programs are compiled, but for warnings. Many files compiled as one: half the time for a build from nothing.
        generator = [] if shutil.which("ninja") else ["-G", "Unix Makefiles"]
        subprocess.run(["cmake", "--preset", "release", *generator, "-B", build, "-DCMAKE_UNITY_BUILD=ON",
                        "-DTAUT_PYTHON=ON", "-DTAUT_PYTHON_PACKAGE=" + package, "-DPython_EXECUTABLE=" + sys.executable,
                        "-DTAUT_APPS=OFF", "-DTAUT_BENCH=OFF", "-DTAUT_TESTS=OFF", "-DTAUT_INSTALL=OFF",
                        "-DTAUT_WERROR=OFF", *pybind11_options(), *flags("CMAKE_ARGS")], check=True, cwd=root)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--target", "_taut2d", "--parallel", jobs], check=True)
        module, = glob.glob(os.path.join(package, "_taut2d*.so"))
        target = self.get_ext_fullpath(extension.name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy(module, target)
        # The viewer's page, where it was built; nothing else needs it.
        page = os.path.join(root, "build", "web", "viewer.html")
        if os.path.exists(page):
            shutil.copy(page, os.path.dirname(target))


setup(ext_modules=[Extension("taut2d._taut2d", sources=[])], cmdclass={"build_ext": CMakeModule})
