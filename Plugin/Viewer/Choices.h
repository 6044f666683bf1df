// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Choices_h
#define limn_viewer_Choices_h

#include "ParseValue.h"     // for Choices
#include "RenderSettings.h" // for the values

/// The served values of options and their names, in the order in which the keys of `limn view` go
/// through them.
namespace limn::viewer
{

const Choices<Shading>& shadings();
const Choices<FlatPoint>& flatPoints();
const Choices<Normals>& normalSources();
const Choices<Reflection>& reflections();
const Choices<Tone>& tones();
const Choices<ToneOverData>& tonesOverData();
const Choices<ToneLight>& toneLights();
const Choices<HatchPlace>& hatchPlaces();
const Choices<RampBy>& rampDetails();
const Choices<Outline>& outlines();
/// Names of vtkLimnStyle.
const Choices<std::string>& styles();
const Choices<LineKind>& lineKinds();
const Choices<LineLights>& lineLights();
const Choices<HiddenLines>& hiddenLines();
const Choices<Detector>& detectors();
const Choices<CreaseDetector>& creaseDetectors();
const Choices<TextureFilter>& textureFilters();
const Choices<TextureWrap>& textureWraps();
const Choices<TextureRole>& textureRoles();
const Choices<TextureMode>& textureModes();
const Choices<Procedural>& procedurals();
const Choices<int>& sampleCounts();

} // namespace limn::viewer

#endif
