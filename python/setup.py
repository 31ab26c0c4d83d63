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


class CMakeModule(build_ext):
    def build_extension(self, extension):
        build = os.path.abspath(os.environ.get("TAUT_PYTHON_BUILD") or self.build_temp)
        package = os.path.join(build, "python", "taut2d")
        # Many files compiled as one: half the time for a build from nothing.
        subprocess.run(["cmake", "-S", root, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON",
                        "-DTAUT_PYTHON=ON", "-DTAUT_PYTHON_PACKAGE=" + package, "-DPython_EXECUTABLE=" + sys.executable,
                        "-DTAUT_APPS=OFF", "-DTAUT_TESTS=OFF", "-DTAUT_INSTALL=OFF"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "_taut2d", "--parallel", str(os.cpu_count() or 1)],
                       check=True)
        module, = glob.glob(os.path.join(package, "_taut2d*.so"))
        target = self.get_ext_fullpath(extension.name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy(module, target)


setup(ext_modules=[Extension("taut2d._taut2d", sources=[])], cmdclass={"build_ext": CMakeModule})
