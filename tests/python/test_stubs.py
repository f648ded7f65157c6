"""The stubs say what the module has: names, parameters, defaults; and everything public is documented."""

import ast
import inspect
import os
import unittest

import percal

FOLDER = os.path.dirname(percal.__file__)
with open(os.path.join(FOLDER, "__init__.pyi"), encoding="utf-8") as file:
    STUBS = ast.parse(file.read())


def parameters_of_stub(function):
    """(name, has a default, its value where it is a literal, keyword only)."""
    arguments = function.args
    positional = arguments.posonlyargs + arguments.args
    defaults = [None] * (len(positional) - len(arguments.defaults)) + arguments.defaults
    found = [(one.arg, default, False) for one, default in zip(positional, defaults)]
    found += [(one.arg, default, True) for one, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]
    return found


class TheStubs(unittest.TestCase):
    def same_parameters(self, name, stub, function):
        real = [
            one
            for one in inspect.signature(function).parameters.values()
            if one.kind not in (inspect.Parameter.VAR_KEYWORD, inspect.Parameter.VAR_POSITIONAL)
        ]
        described = parameters_of_stub(stub)
        if described and described[0][0] in ("self", "cls") and (not real or real[0].name != described[0][0]):
            described = described[1:]  # bound already
        self.assertEqual([one.name for one in real], [one[0] for one in described], name)
        for one, (_, default, keyword_only) in zip(real, described):
            where = f"{name}({one.name})"
            self.assertEqual(one.default is not inspect.Parameter.empty, default is not None, where)
            self.assertEqual(one.kind == inspect.Parameter.KEYWORD_ONLY, keyword_only, where)
            if default is not None and not (isinstance(default, ast.Constant) and default.value is ...):
                self.assertEqual(one.default, ast.literal_eval(default), where)

    def test_have_every_public_name(self):
        described = {one.name for one in STUBS.body if isinstance(one, (ast.FunctionDef, ast.ClassDef))}
        described = {name for name in described if not name.startswith("_")} | {"__version__"}
        self.assertEqual(described, set(percal.__all__))

    def test_have_the_functions_parameters(self):
        core = ("default_store_path", "instruction_level")  # of the compiled part, without parameters
        for stub in STUBS.body:
            if isinstance(stub, ast.FunctionDef) and stub.name not in core:
                self.same_parameters(stub.name, stub, getattr(percal, stub.name))

    def test_have_the_classes_methods(self):
        for stub in (one for one in STUBS.body if isinstance(one, ast.ClassDef) and hasattr(percal, one.name)):
            real = getattr(percal, stub.name)
            methods = {one.name: one for one in stub.body if isinstance(one, ast.FunctionDef)}
            for name, method in methods.items():
                attribute = inspect.getattr_static(real, name)
                if isinstance(attribute, property):
                    self.assertEqual([one.id for one in method.decorator_list], ["property"], name)
                else:
                    self.same_parameters(f"{stub.name}.{name}", method, getattr(real, name))
            public = {name for name in vars(real) if not name.startswith("_")}
            attributes = {one.target.id for one in stub.body if isinstance(one, ast.AnnAssign)}
            self.assertLessEqual(public - set(methods) - attributes, set(), stub.name)

    def test_have_the_attributes_that_objects_have(self):
        fit = percal.fit([1.1, 1.2, 1.3, 1.4], [10e3, 19e3, 27e3, 36e3])
        for thing in (fit, fit.minima[0]):
            stub = next(one for one in STUBS.body if getattr(one, "name", "") == type(thing).__name__)
            described = {one.target.id for one in stub.body if isinstance(one, ast.AnnAssign)}
            self.assertEqual(described, {name for name in vars(thing) if not name.startswith("_")})

    def test_are_marked_as_there(self):
        self.assertTrue(os.path.exists(os.path.join(FOLDER, "py.typed")))


class TheModule(unittest.TestCase):
    def test_documents_every_public_name(self):
        for name in percal.__all__:
            thing = getattr(percal, name)
            if inspect.isfunction(thing) or inspect.isclass(thing):
                self.assertTrue(thing.__doc__, name)
                for method, value in vars(thing).items():
                    if not method.startswith("_") and callable(value):
                        self.assertTrue(value.__doc__, f"{name}.{method}")

    def test_has_a_version(self):
        self.assertRegex(percal.__version__, r"^\d+\.\d+\.\d+$")


if __name__ == "__main__":
    unittest.main()
