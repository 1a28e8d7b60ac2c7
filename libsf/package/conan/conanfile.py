# libsf for Conan 2, from the tree that this file lies in: conan create libsf/package/conan
#
# meson and ninja are looked for in PATH; `-c tools.meson...` or a tool_requires of the profile says
# otherwise. Without the options png and hdf5 it needs nothing but a C compiler.

import os

from conan import ConanFile
from conan.tools.files import copy, load, rmdir
from conan.tools.gnu import PkgConfigDeps
from conan.tools.layout import basic_layout
from conan.tools.meson import Meson, MesonToolchain

TREE = os.path.join("..", "..", "..")


class LibsfConan(ConanFile):
    name = "libsf"
    license = "MIT"
    description = "Shapes that print without supports, balance, and grade"
    topics = ("3d-printing", "voxels", "geometry")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "png": [True, False], "hdf5": [True, False]}
    default_options = {"shared": False, "fPIC": True, "png": True, "hdf5": False}
    languages = "C"
    implements = ["auto_shared_fpic"]

    def set_version(self):
        text = load(self, os.path.join(self.recipe_folder, TREE, "meson.build"))
        self.version = text.split("version: '", 1)[1].split("'", 1)[0]

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, TREE)
        for pattern in ("libsf/*", "meson.build", "meson_options.txt", "LICENSE"):
            copy(self, pattern, tree, self.export_sources_folder)

    def layout(self):
        basic_layout(self, src_folder=".")

    def requirements(self):
        if self.options.png:
            self.requires("libspng/0.7.4")
            self.requires("jansson/2.14")
        if self.options.hdf5:
            self.requires("hdf5/1.14.5")

    def generate(self):
        def feature(name):
            return "enabled" if self.options.get_safe(name) else "disabled"

        chain = MesonToolchain(self)
        chain.project_options.update({
            "demo": False, "tests": False, "auto_features": "disabled",
            "png": feature("png"), "json": feature("png"), "hdf5": feature("hdf5")})
        chain.generate()
        PkgConfigDeps(self).generate()

    def build(self):
        meson = Meson(self)
        meson.configure()
        meson.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        Meson(self).install()
        # Conan writes both of these for whoever asks, with the places of this package.
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "libsf")
        static = [] if self.options.shared else ["SF_STATIC"]
        libm = ["m"] if self.settings.os in ("Linux", "FreeBSD") else []
        for name, needs in (("sf", []), ("sf-io", ["sf"])):
            part = self.cpp_info.components[name]
            part.libs, part.requires, part.defines, part.system_libs = [name], list(needs), static, libm
            part.set_property("cmake_target_name", f"sf::{name}")
            part.set_property("pkg_config_name", "lib" + name)
        files = self.cpp_info.components["sf-io"]
        if self.options.png:
            files.requires += ["libspng::libspng", "jansson::jansson"]
        if self.options.hdf5:
            files.requires.append("hdf5::hdf5_c")
