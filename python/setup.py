# SPDX-License-Identifier: Apache-2.0
"""Build the wheel from a folder that holds the package with its compiled part (`make wheel`)."""
from setuptools import Distribution, setup


class WithCompiledPart(Distribution):
    """The wheel belongs to one platform and one version of Python."""

    def has_ext_modules(self) -> bool:
        return True


setup(name="hawser", version="0.1.0", packages=["hawser"],
      package_data={"hawser": ["*.so", "*.pyi", "py.typed", "bin/hawser"]}, include_package_data=True,
      description="Real-time multibody dynamics of ships, cranes, winches, rigs and cables",
      license="Apache-2.0", python_requires=">=3.11", install_requires=["numpy"],
      distclass=WithCompiledPart)
