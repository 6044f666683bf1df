# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""What "import limn" does, each time in a process of its own."""

import os
import subprocess
import sys
import tempfile
import unittest

SCENE = """
import sys
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

cone = vtkConeSource()
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(cone.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(1.0, 0.5, 0.0)
renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(64, 64)
window.AddRenderer(renderer)
window.Render()
image = vtkWindowToImageFilter()
image.SetInput(window)
image.Update()
print([image.GetOutput().GetScalarComponentAsDouble(32, 32, 0, i) > 0 for i in range(3)])
print(type(mapper).__module__, type(mapper).__name__, window.GetClassName())
print(any(name in open("/proc/self/maps").read() for name in ("libGL", "libOpenGL", "libX11")))
"""


def run(program, remove=(), **environment):
    """The lines that a Python program prints."""
    env = {name: value for name, value in os.environ.items() if name not in remove}
    env.update(environment)
    done = subprocess.run(
        [sys.executable, "-c", program], env=env, capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise AssertionError(f"status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout.splitlines()


class ImportTest(unittest.TestCase):
    def test_before_vtk(self):
        lit, names, _ = run("import limn\nimport vtkmodules.vtkRenderingOpenGL2\n" + SCENE)
        self.assertEqual(lit, "[True, True, False]")
        self.assertEqual(names, "limn.vtkLimn vtkLimnPolyDataMapper vtkXOpenGLRenderWindow")

    def test_after_vtk(self):
        lit, names, _ = run("import vtkmodules.vtkRenderingOpenGL2\nimport limn\n" + SCENE)
        self.assertEqual(lit, "[True, True, False]")
        self.assertEqual(names, "limn.vtkLimn vtkLimnPolyDataMapper vtkXOpenGLRenderWindow")

    def test_without_display(self):
        lit, names, graphics = run("import limn\n" + SCENE, ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual(lit, "[True, True, False]")
        self.assertEqual(names, "limn.vtkLimn vtkLimnPolyDataMapper vtkLimnRenderWindow")
        self.assertEqual(graphics, "False")

    def test_disabled(self):
        program = "import limn\nimport vtkmodules.vtkRenderingOpenGL2\n" + SCENE
        _, names, _ = run(program, LIMN_DISABLE="1")
        self.assertIn("vtkOpenGLPolyDataMapper vtkXOpenGLRenderWindow", names)

    def test_actors_that_vtk_makes(self):
        """An image is drawn by an actor that VTK makes for itself and takes to be OpenGL's."""
        (line,) = run("""
import limn
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkImageActor, vtkRenderer, vtkRenderWindow
source = vtkRTAnalyticSource()
image = vtkImageActor()
image.GetMapper().SetInputConnection(source.GetOutputPort())
renderer = vtkRenderer()
renderer.AddActor(image)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.AddRenderer(renderer)
window.Render()
print("drawn")
""")
        self.assertEqual(line, "drawn")

    def test_volumes_without_display(self):
        (line,) = run("""
import limn
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper
print(vtkSmartVolumeMapper().GetClassName())
""", ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual(line, "vtkSmartVolumeMapper")

    def test_vector_graphics_without_display(self):
        """VTK's exporter finds no vectors in our window and embeds the picture."""
        with tempfile.TemporaryDirectory() as folder:
            run("import limn\n" + SCENE + f"""
import vtkmodules.vtkRenderingGL2PSOpenGL2
from vtkmodules.vtkIOExportGL2PS import vtkGL2PSExporter
exporter = vtkGL2PSExporter()
exporter.SetRenderWindow(window)
exporter.SetFilePrefix("{folder}/cone")
exporter.SetFileFormatToEPS()
exporter.CompressOff()
exporter.Write()
""", ["DISPLAY"], LIMN_WINDOW="cpu")
            with open(f"{folder}/cone.eps", encoding="latin-1") as page:
                self.assertIn("64 64 8", page.read())

    def test_mappers_that_need_opengl(self):
        """Each is named once, with advice that fits a window without OpenGL."""
        *_, glyphs, splats, spheres, advice = run("import limn\n" + SCENE + """
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkRenderingCore import vtkGlyph3DMapper, vtkPointGaussianMapper
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper
messages = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(messages)
mappers = (vtkGlyph3DMapper(), vtkPointGaussianMapper(), vtkOpenGLSphereMapper())
for one in mappers:
    one.SetInputConnection(cone.GetOutputPort())
    other = vtkActor()
    other.SetMapper(one)
    renderer.AddActor(other)
window.Render()
window.Render()
for one in mappers:
    print(messages.GetOutput().count(f"A {one.GetClassName()} draws in OpenGL windows only"))
print("LIMN_WINDOW=gl" in messages.GetOutput(), "LIMN_WINDOW=cpu" in messages.GetOutput())
""", ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual([glyphs, splats, spheres, advice], ["1", "1", "1", "True False"])

    def test_widgets_without_display(self):
        *_, border, distance = run("import limn\n" + SCENE + """
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkInteractionWidgets import vtkBorderRepresentation, vtkDistanceRepresentation2D
messages = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(messages)
for one in (vtkBorderRepresentation(), vtkDistanceRepresentation2D()):
    renderer.AddViewProp(one)
    window.Render()
    window.Render()
    print(messages.GetOutput().count(f"A {one.GetClassName()} is not drawn"))
""", ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual([border, distance], ["1", "1"])

    def test_polygon_of_no_points(self):
        scene = SCENE.replace("actor.SetMapper(mapper)", """
from vtkmodules.vtkCommonCore import vtkIdList
cone.Update()
for i in range(80):
    cone.GetOutput().GetPolys().InsertNextCell(0)
mapper.SetInputDataObject(cone.GetOutput())
actor.SetMapper(mapper)""")
        lit, *_ = run("import limn\n" + scene, ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual(lit, "[True, True, False]")

    def test_post_effects(self):
        scene = SCENE.replace(
            "renderer.AddActor(actor)",
            """renderer.AddActor(actor)
from limn import vtkLimnPostEffects
effects = vtkLimnPostEffects()
effects.SetExposure(0)
renderer.SetPostEffects(effects)""",
        )
        plain, *_ = run("import limn\n" + SCENE, ["DISPLAY"], LIMN_WINDOW="cpu")
        dark, *_ = run("import limn\n" + scene, ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertNotEqual(dark, plain)

    def test_styles(self):
        """An ordinary property is replaced, with its values."""
        names, applied, look = run("""
import limn
from limn import vtkLimnActor, vtkLimnPolyDataMapper, vtkLimnRenderer, vtkLimnStyle
from vtkmodules.vtkRenderingCore import vtkProperty
print(*(vtkLimnStyle.GetStyleName(i) for i in range(vtkLimnStyle.GetNumberOfStyles())))
actor, mapper, renderer, own = vtkLimnActor(), vtkLimnPolyDataMapper(), vtkLimnRenderer(), vtkProperty()
own.SetColor(0.25, 0.5, 0.75)
actor.SetMapper(mapper)
actor.SetProperty(own)
renderer.AddActor(actor)
print(vtkLimnStyle.Apply(renderer, "technical"))
look = actor.GetProperty()
print(look.GetClassName(), look.GetToneAsString(), look.GetContourLines(), look.GetColor())
""", ["DISPLAY"], LIMN_WINDOW="cpu")
        self.assertEqual(names, "plain technical gooch toon blueprint pencil ink anatomy metal xray print")
        self.assertEqual(applied, "True")
        self.assertEqual(look, "vtkLimnProperty Gooch True (0.25, 0.5, 0.75)")

    def test_shaders_are_for_cpp(self):
        lines = run(
            "import limn\n"
            "for name in ('vtkLimnSurfaceShader', 'vtkLimnVertexShader'):\n"
            "    try:\n"
            "        getattr(limn, name)()\n"
            "        print('made')\n"
            "    except (TypeError, NotImplementedError) as error:\n"
            "        print('refused')\n"
            "print(limn.vtkLimnProperty().GetSurfaceShader(), limn.vtkLimnPolyDataMapper().GetVertexShader())")
        self.assertEqual(lines, ["refused", "refused", "None None"])

    def test_names(self):
        (line,) = run("import limn\nprint(sorted(n for n in dir(limn) if n.startswith('vtkLimn')))")
        for name in ("Actor", "OpenGLCompositor", "PolyDataMapper", "PostEffects", "Property", "RenderWindow"):
            self.assertIn(f"'vtkLimn{name}'", line)


if __name__ == "__main__":
    unittest.main()
