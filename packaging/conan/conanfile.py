"""The library for Conan 2: conan create packaging/conan."""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class TautConan(ConanFile):
    name = "taut"
    version = "0.1.0"
    license = "MIT"
    description = "Exactly when moving shapes first touch, or a proof that they never do"
    topics = ("geometry", "collision-detection", "kinetic", "exact")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"fPIC": [True, False]}
    default_options = {"fPIC": True, "boost/*:header_only": True}

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        # Of the library's inside only: its public headers need the standard library alone.
        self.requires("boost/1.83.0", visible=False)
        self.requires("fmt/9.1.0", visible=False)
        self.requires("nlohmann_json/3.11.2", visible=False)

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for name in ("TAUT_APPS", "TAUT_TESTS", "TAUT_BENCH"):
            toolchain.cache_variables[name] = False
        # The library takes its headers from the compiler's search path.
        folders = [d for name in ("boost", "fmt", "nlohmann_json") for d in self.dependencies[name].cpp_info.includedirs]
        toolchain.cache_variables["CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES"] = ";".join(folders)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="taut")

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["taut"]
        self.cpp_info.set_property("cmake_file_name", "taut")
        self.cpp_info.set_property("cmake_target_name", "taut::taut")
        self.cpp_info.set_property("pkg_config_name", "taut")
