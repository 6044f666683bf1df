// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Actors drawn through RenderWithBackend against VTK's own: the same bytes, the same selections.
#include "GLScene.h"
#include "Looks.h"
#include "SelectedIds.h"

#include "vtkLimnCompositor.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <tuple>
#include <vector>

namespace
{
/// A mapper that has everything but a way to draw.
class BareMapper : public vtkPolyDataMapper
{
public:
  static BareMapper* New();
  vtkTypeMacro(BareMapper, vtkPolyDataMapper);
  void RenderPiece(vtkRenderer*, vtkActor*) override {}
};
vtkStandardNewMacro(BareMapper);

/// A property that sets up nothing.
class BareProperty : public vtkProperty
{
public:
  static BareProperty* New();
  vtkTypeMacro(BareProperty, vtkProperty);
};
vtkStandardNewMacro(BareProperty);

/// An actor of no backend that a compositor draws.
class HandedOverActor : public vtkActor
{
public:
  static HandedOverActor* New();
  vtkTypeMacro(HandedOverActor, vtkActor);
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    if (vtkPolyDataMapper* bare = BareMapper::SafeDownCast(mapper))
    {
      this->Compositor->RenderWithBackend(renderer, this, bare);
    }
    else
    {
      this->Compositor->RenderMapperWithBackend(renderer, this, mapper);
    }
  }
  vtkSmartPointer<vtkLimnCompositor> Compositor;
};
vtkStandardNewMacro(HandedOverActor);

vtkSmartPointer<vtkActor> MakeHandedOverActor(
  vtkAlgorithmOutput* source, vtkLimnCompositor* compositor)
{
  vtkNew<BareMapper> mapper;
  mapper->SetInputConnection(source);
  vtkSmartPointer<HandedOverActor> actor = vtkSmartPointer<HandedOverActor>::New();
  vtkNew<BareProperty> property;
  actor->Compositor = compositor;
  actor->SetProperty(property);
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkLimnCompositor> MakeCompositor()
{
  return vtkSmartPointer<vtkLimnCompositor>::Take(vtkLimnCompositor::New());
}

/// The same scene with an actor of VTK's and with one that is handed over.
class TwoScenes
{
public:
  explicit TwoScenes(int multiSamples) : Expected(multiSamples), HandedOver(multiSamples)
  {
    this->Source->SetOutput(MakeQuads());
    this->ExpectedActor = MakeGLActor(this->Source->GetOutputPort());
    this->HandedOverActor = MakeHandedOverActor(this->Source->GetOutputPort(), this->Compositor);
    this->Expected.Renderer->AddActor(this->ExpectedActor);
    this->HandedOver.Renderer->AddActor(this->HandedOverActor);
  }

  void Apply(const std::function<void(vtkActor*)>& change)
  {
    change(this->ExpectedActor);
    change(this->HandedOverActor);
  }

  int CountDifferent()
  {
    return ::CountDifferent(this->Expected.Render(), this->HandedOver.Render());
  }

  vtkNew<vtkTrivialProducer> Source;
  vtkSmartPointer<vtkLimnCompositor> Compositor = MakeCompositor();
  GLScene Expected;
  GLScene HandedOver;
  vtkSmartPointer<vtkActor> ExpectedActor;
  vtkSmartPointer<vtkActor> HandedOverActor;
};
} // namespace

class LookTest : public testing::TestWithParam<std::tuple<Look, int>>
{
};

TEST_P(LookTest, EqualsVtkByteForByte)
{
  TwoScenes scenes(std::get<1>(GetParam()));
  GLScene empty(std::get<1>(GetParam()));
  scenes.Apply(std::get<0>(GetParam()).Apply);
  EXPECT_EQ(scenes.CountDifferent(), 0);
  EXPECT_GT(CountDifferent(scenes.Expected.Read(), empty.Render()), 100) << "nothing to see";
}
INSTANTIATE_TEST_SUITE_P(AllLooks, LookTest,
  testing::Combine(testing::ValuesIn(Looks), testing::Values(0, 4)),
  [](const auto& test)
  {
    return std::string(std::get<0>(test.param).Name) + "With" +
           std::to_string(std::get<1>(test.param)) + "Samples";
  });

// What the user changes between frames has to reach the drawing too.
TEST(BackendActor, FollowsChanges)
{
  TwoScenes scenes(0);
  scenes.Apply([](vtkActor* actor) { actor->GetProperty()->SetRepresentationToWireframe(); });
  Picture before = scenes.HandedOver.Render();
  const std::vector<std::function<void(vtkActor*)>> changes = {
    [](vtkActor* actor) { actor->GetProperty()->SetRepresentationToSurface(); },
    [](vtkActor* actor) { actor->SetPosition(0.2, 0.1, 0.0); },
    [](vtkActor* actor) { actor->GetMapper()->ScalarVisibilityOff(); },
    [](vtkActor* actor) { actor->GetProperty()->SetColor(0.3, 0.9, 0.1); },
    [](vtkActor* actor) { actor->GetProperty()->SetOpacity(0.5); },
    [](vtkActor* actor) { actor->SetTexture(MakeTexture()); },
    [](vtkActor* actor) { actor->SetPosition(0.0, 0.0, 0.0); },
  };
  for (const auto& change : changes)
  {
    scenes.Apply(change);
    EXPECT_EQ(scenes.CountDifferent(), 0);
    const Picture after = scenes.HandedOver.Read();
    EXPECT_GT(CountDifferent(before, after), 100) << "the change is not to be seen";
    before = after;
  }
}

// An assembly draws its parts with a matrix of its own.
TEST(BackendActor, FollowsAssemblies)
{
  TwoScenes scenes(0);
  for (GLScene* scene : { &scenes.Expected, &scenes.HandedOver })
  {
    scene->Renderer->RemoveAllViewProps();
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(scene == &scenes.Expected ? scenes.ExpectedActor : scenes.HandedOverActor);
    assembly->RotateZ(40.0);
    assembly->SetPosition(0.2, 0.1, 0.3);
    scene->Renderer->AddViewProp(assembly);
  }
  EXPECT_EQ(scenes.CountDifferent(), 0);
}

// Mappers that VTK's OpenGL brings itself (here the composite one) expect an OpenGL actor.
TEST(BackendActor, DrawsMappersOfOpenGLs)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeQuads());
  Picture pictures[2];
  int references[2];
  for (int handedOver = 0; handedOver < 2; ++handedOver)
  {
    GLScene scene(0);
    vtkNew<vtkCompositePolyDataMapper2> mapper;
    mapper->SetInputDataObject(blocks);
    vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkOpenGLActor>::New();
    if (handedOver)
    {
      vtkSmartPointer<HandedOverActor> foreign = vtkSmartPointer<HandedOverActor>::New();
      foreign->Compositor = MakeCompositor();
      actor = foreign;
    }
    actor->SetMapper(mapper);
    vtkNew<vtkOpenGLProperty> property;
    property->BackfaceCullingOn();
    actor->SetProperty(property);
    actor->SetPosition(0.2, 0.1, 0.0);
    scene.Renderer->AddActor(actor);
    pictures[handedOver] = scene.Render();
    references[handedOver] = mapper->GetReferenceCount();
  }
  EXPECT_EQ(CountDifferent(pictures[0], pictures[1]), 0);
  EXPECT_GT(CountDifferent(pictures[0], GLScene(0).Render()), 1000);
  EXPECT_EQ(references[0], references[1]) << "the mapper must not be kept alive";
}

class SelectionTest : public testing::TestWithParam<int>
{
};

// Quadrilaterals are two primitives each, so a primitive's number is not its cell's. The selection
// has to name the user's actor, never the one that drew for it.
TEST_P(SelectionTest, NamesActorsAndCells)
{
  TwoScenes scenes(0);
  vtkSmartPointer<vtkActor> expectedSecond = MakeGLActor(scenes.Source->GetOutputPort());
  vtkSmartPointer<vtkActor> second =
    MakeHandedOverActor(scenes.Source->GetOutputPort(), scenes.Compositor);
  expectedSecond->SetPosition(0.4, 0.5, 0.8);
  second->SetPosition(0.4, 0.5, 0.8);
  scenes.Expected.Renderer->AddActor(expectedSecond);
  scenes.HandedOver.Renderer->AddActor(second);
  scenes.CountDifferent();

  for (int repetition = 0; repetition < 2; ++repetition)
  {
    SelectedIds expected = Select(scenes.Expected, GetParam());
    SelectedIds cells = Select(scenes.HandedOver, GetParam());
    EXPECT_EQ(cells.size(), 2u);
    EXPECT_GT(expected[scenes.ExpectedActor].size(), 5u);
    EXPECT_EQ(cells[scenes.HandedOverActor], expected[scenes.ExpectedActor]);
    EXPECT_EQ(cells[second], expected[expectedSecond]);
    scenes.HandedOver.Renderer->RemoveActor(scenes.HandedOverActor);
    scenes.HandedOver.Renderer->AddActor(scenes.HandedOverActor);
    scenes.Expected.Renderer->RemoveActor(scenes.ExpectedActor);
    scenes.Expected.Renderer->AddActor(scenes.ExpectedActor);
  }
}
INSTANTIATE_TEST_SUITE_P(CellsAndPoints, SelectionTest,
  testing::Values(vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS));

// What draws for an actor goes with it, and lets go of what it shared.
TEST(BackendActor, GoesWithItsActor)
{
  vtkSmartPointer<vtkLimnCompositor> compositor = MakeCompositor();
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(MakeQuads());
  vtkNew<BareMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkProperty> property;
  vtkNew<vtkLookupTable> table;
  GLScene scene(0);
  {
    vtkSmartPointer<vtkActor> actor = MakeHandedOverActor(source->GetOutputPort(), compositor);
    actor->SetProperty(property);
    actor->GetMapper()->SetLookupTable(table);
    scene.Renderer->AddActor(actor);
    scene.Render();
    EXPECT_EQ(property->GetReferenceCount(), 3) << "here, the actor, its twin";
    EXPECT_EQ(table->GetReferenceCount(), 3);
    actor->SetMapper(nullptr);
    EXPECT_EQ(property->GetReferenceCount(), 2);
    EXPECT_EQ(table->GetReferenceCount(), 1);

    actor->SetMapper(mapper);
    scene.Render();
    EXPECT_EQ(property->GetReferenceCount(), 3);
    scene.Renderer->RemoveActor(actor);
  }
  EXPECT_EQ(property->GetReferenceCount(), 1);
}

// Each event of a mapper asks all its observers: one for each of its actors would be a frame time
// that grows with the square of their number.
TEST(BackendActor, ObservesAMapperOnceForAllItsActors)
{
  vtkSmartPointer<vtkLimnCompositor> compositor = MakeCompositor();
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(MakeQuads());
  vtkNew<BareMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  GLScene scene(0);
  constexpr int kActors = 20;
  for (int i = 0; i < kActors; ++i)
  {
    vtkSmartPointer<vtkActor> actor = MakeHandedOverActor(source->GetOutputPort(), compositor);
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
  }
  // Observers of an object are numbered.
  vtkNew<vtkCallbackCommand> nobody;
  const unsigned long first = mapper->AddObserver(vtkCommand::UserEvent, nobody);
  scene.Render();
  EXPECT_LT(mapper->AddObserver(vtkCommand::UserEvent, nobody) - first, 5u);
}

// Windows, actors and the compositor may go in any order, and graphics resources come back.
TEST(BackendActor, SurvivesReleaseOfResources)
{
  TwoScenes scenes(0);
  scenes.HandedOver.Render();
  scenes.Compositor->ReleaseGraphicsResources(scenes.HandedOver.Window);
  EXPECT_EQ(scenes.CountDifferent(), 0);
  scenes.HandedOver.Window->Finalize();
  EXPECT_EQ(scenes.CountDifferent(), 0);
  {
    GLScene other(0);
    other.Renderer->AddActor(scenes.HandedOverActor);
    EXPECT_EQ(CountDifferent(other.Render(), scenes.Expected.Read()), 0);
  }
  EXPECT_EQ(scenes.CountDifferent(), 0);
}
