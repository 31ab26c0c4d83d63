"""What objects have in common that are JSON texts of the format taut-scene/1."""

from __future__ import annotations

import os
from typing import Type, TypeVar, Union

from .errors import InputError

_Form = TypeVar("_Form", bound="TextForm")


class TextForm:
    """Reads and writes itself as text, in memory and in files."""

    def to_json(self) -> str:
        raise NotImplementedError

    @classmethod
    def _read(cls: Type[_Form], text: str, name: str, folder: Union[str, os.PathLike[str]]) -> _Form:
        """From a text that errors call ``name``."""
        raise NotImplementedError

    @classmethod
    def from_json(cls: Type[_Form], text: str, *, folder: Union[str, os.PathLike[str]] = ".") -> _Form:
        """What a JSON text in the format taut-scene/1 describes; files that it names are looked up in ``folder``. Raises
        InputError with line and column if it is not such a text."""
        return cls._read(text, "scene", folder)

    @classmethod
    def load(cls: Type[_Form], path: Union[str, os.PathLike[str]]) -> _Form:
        """Reads a file. Files that it names are found relative to its folder. Raises InputError with line and column if it
        is not right, and OSError if it cannot be read."""
        path = os.fspath(path)
        with open(path, "rb") as file:
            data = file.read()
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError as error:
            raise InputError(path, "the file is not UTF-8") from error
        return cls._read(text, path, os.path.dirname(path) or os.curdir)

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes to_json() and a line break into a file. Paths of files that bodies name stay as they are."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.to_json() + "\n")
