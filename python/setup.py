"""Builds the compiled part with CMake, from the folder above; pyproject.toml has the rest.

TAUT_PYTHON_BUILD names a CMake build folder to use and keep; without it, one is made for the occasion.
"""

import glob
import os
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


# What CMake looks for, and Debian's packages that have it.
headers = {"boost/multiprecision/cpp_int.hpp": "libboost-dev", "nlohmann/json.hpp": "nlohmann-json3-dev",
           "fmt/format.h": "libfmt-dev"}


def require_tools():
    """Says at once what is missing, instead of CMake's pages about the first thing that is."""
    missing = [package for tool, package in (("cmake", "cmake"), ("c++", "g++")) if not shutil.which(tool)]
    folders = ["/usr/include", "/usr/local/include", *os.environ.get("CPLUS_INCLUDE_PATH", "").split(":")]
    if os.path.exists("/etc/debian_version"):
        missing += [package for header, package in headers.items()
                    if not any(folder and os.path.exists(os.path.join(folder, header)) for folder in folders)]
    if missing:
        raise SystemExit("taut2d is compiled here, and needs " + ", ".join(missing) +
                         " besides. On Debian: apt install g++ cmake ninja-build libboost-dev nlohmann-json3-dev "
                         "libfmt-dev pybind11-dev python3-dev")


def pybind11_options():
    """That of the environment, if it has one; else CMake finds the system's."""
    try:
        import pybind11
    except ImportError:
        return []
    return ["-Dpybind11_DIR=" + pybind11.get_cmake_dir()]


class CMakeModule(build_ext):
    def build_extension(self, extension):
        require_tools()
        build = os.path.abspath(os.environ.get("TAUT_PYTHON_BUILD") or self.build_temp)
        package = os.path.join(build, "python", "taut2d")
        # Many files compiled as one: half the time for a build from nothing.
        subprocess.run(["cmake", "-S", root, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                        "-DTAUT_PYTHON=ON", "-DTAUT_PYTHON_PACKAGE=" + package, "-DPython_EXECUTABLE=" + sys.executable,
                        "-DTAUT_APPS=OFF", "-DTAUT_TESTS=OFF", "-DTAUT_INSTALL=OFF", *pybind11_options()], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "_taut2d", "--parallel", str(os.cpu_count() or 1)],
                       check=True)
        module, = glob.glob(os.path.join(package, "_taut2d*.so"))
        target = self.get_ext_fullpath(extension.name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy(module, target)


setup(ext_modules=[Extension("taut2d._taut2d", sources=[])], cmdclass={"build_ext": CMakeModule})
