// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewCommand.h"

#include "BuildScene.h"
#include "Choices.h"
#include "LoadMesh.h"
#include "Messages.h"
#include "OpenWindow.h"

#include "vtkLimnProperty.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <filesystem>
#include <iostream>

namespace limn::viewer
{
namespace
{

const char* const kKeys = R"(Keys
  s  shading: flat, gouraud, phong
  l  reflection of light: none, lambert, phong, blinn-phong,
     irradiance, oren-nayar, metallic
  t  tone: none, gooch, gooch-chapter, gooch-rtr4,
     gooch-orange-book, metal, toon
  o  outline: none, normal, hull, image
  y  style: plain, technical, gooch, toon, blueprint, pencil, ink,
     anatomy, metal, xray, print
  m  samples per pixel: 1, 2, 4, 8, 16
  r  reset the camera
  h  print this text
  q  quit
Mouse
  left button turns, middle or shift + left moves, right or wheel zooms
)";

template <typename Value>
std::size_t indexOf(const Choices<Value>& choices, Value value)
{
  std::size_t index = 0;
  while (index + 1 < choices.size() && choices[index].second != value)
  {
    ++index;
  }
  return index;
}

template <typename Value>
const std::string& nameOf(const Choices<Value>& choices, Value value)
{
  return choices[indexOf(choices, value)].first;
}

template <typename Value>
Value next(const Choices<Value>& choices, Value value)
{
  return choices[(indexOf(choices, value) + 1) % choices.size()].second;
}

template <typename Value>
void advance(const Choices<Value>& choices, Value& value)
{
  value = next(choices, value);
}

Reflection reflectionOf(const MaterialSettings& material)
{
  return material.reflection.value_or(kDefaultReflection);
}

std::string toneName(Tone tone)
{
  return tone == Tone::Ramp ? "ramp" : tone == Tone::MatCap ? "matcap" : nameOf(tones(), tone);
}

/// What is on the screen and how it looks at the moment.
class View
{
public:
  View(const SceneSettings& settings, const std::vector<Mesh>& meshes)
    : settings_(settings), meshes_(meshes), pictures_(loadTonePictures(settings.material)),
      opened_(openWindow(Window::Gl, settings))
  {
    buildScene(this->settings_, this->meshes_, *this->opened_.renderer);
  }

  vtkRenderWindow& window() { return *this->opened_.window; }

  /// True if the key means something here.
  bool press(char key)
  {
    MaterialSettings& material = this->settings_.material;
    switch (key)
    {
      case 's':
        advance(shadings(), material.shading);
        break;
      case 'l':
        material.reflection = next(reflections(), reflectionOf(material));
        material.localModel.reset();
        break;
      case 't':
        advance(tones(), material.tone);
        break;
      case 'o':
        advance(outlines(), material.outline);
        break;
      case 'y':
        this->settings_.style = this->settings_.style.empty()
                                  ? styles().front().second
                                  : next(styles(), this->settings_.style);
        break;
      case 'm':
        advance(sampleCounts(), this->settings_.samples);
        break;
      case 'r':
        this->resetCamera();
        break;
      default:
        return false;
    }
    this->draw();
    return true;
  }

  void draw()
  {
    vtkActorCollection* const actors = this->opened_.renderer->GetActors();
    actors->InitTraversal();
    for (const Mesh& mesh : this->meshes_)
    {
      vtkActor* const actor = actors->GetNextActor();
      applyLook(this->settings_, mesh, this->pictures_,
        *vtkLimnProperty::SafeDownCast(actor->GetProperty()));
    }
    setBackground(this->settings_, *this->opened_.renderer);
    this->window().SetMultiSamples(this->settings_.samples);
    this->window().SetWindowName(this->title().c_str());
    this->window().Render();
  }

private:
  void resetCamera()
  {
    const int* const size = this->window().GetSize();
    this->settings_.resolution = { size[0], size[1] };
    pointCamera(this->settings_, this->meshes_, *this->opened_.renderer);
  }

  std::string title() const
  {
    const MaterialSettings& material = this->settings_.material;
    const std::string first = std::filesystem::path(this->meshes_[0].file).filename().string();
    return "limn: " + first + (this->meshes_.size() > 1 ? ", ..." : "") + " | shading " +
           nameOf(shadings(), material.shading) + " | reflection " +
           (material.localModel ? "model " + std::to_string(*material.localModel)
                                : nameOf(reflections(), reflectionOf(material))) +
           " | tone " + toneName(material.tone) + " | outline " +
           nameOf(outlines(), material.outline) +
           (this->settings_.style.empty() ? "" : " | style " + this->settings_.style) +
           " | samples " + std::to_string(this->settings_.samples) + " | h: keys";
  }

  SceneSettings settings_;
  const std::vector<Mesh>& meshes_;
  TonePictures pictures_;
  OpenedWindow opened_;
};

/// Trackball, and the keys of kKeys in place of VTK's own (wireframe, picking, stereo, ...).
class ViewStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewStyle* New() { VTK_STANDARD_NEW_BODY(ViewStyle); }

  void OnChar() override
  {
    const char key = this->Interactor->GetKeyCode();
    if (key == 'h')
    {
      std::cout << kKeys << std::flush;
    }
    else if (key == 'q')
    {
      this->Interactor->ExitCallback();
    }
    else
    {
      this->Shown->press(key);
    }
  }

  View* Shown = nullptr;

protected:
  ViewStyle() = default;
  ~ViewStyle() override = default;

private:
  ViewStyle(const ViewStyle&) = delete;
  void operator=(const ViewStyle&) = delete;
};

} // namespace

ExitStatus view(const SceneSettings& settings)
{
  preferWindow(Window::Gl);
  const std::vector<Mesh> meshes = loadMeshes(settings.meshes);
  View shown(settings, meshes);
  vtkNew<ViewStyle> style;
  style->Shown = &shown;
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(&shown.window());
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  shown.draw();
  throwCollectedErrors();
  interactor->Start();
  throwCollectedErrors();
  return ExitSuccess;
}

} // namespace limn::viewer
