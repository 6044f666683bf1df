// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinePainter.h"

#include "SampleMatch.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

namespace
{
const char* const PlacePixel = R"(
//VTK::System::Dec
in vec2 place;
in float depth;
in vec4 color;
in float samples;
uniform vec2 layerSize;
out vec4 lineColor;
out float lineDepth;
out float lineSamples;
void main()
{
  lineColor = color;
  lineDepth = depth;
  lineSamples = samples;
  gl_PointSize = 1.0;
  gl_Position = vec4((place + 0.5) / layerSize * 2.0 - 1.0, 0.0, 1.0);
}
)";

const char* const BeginPixel = R"(
//VTK::System::Dec
#extension GL_ARB_sample_shading : enable
//VTK::Output::Dec
in vec4 lineColor;
in float lineDepth;
in float lineSamples;
uniform int sampleCount;
uniform int layerSample[32];
void main()
{
  gl_FragDepth = lineDepth;
  int open = int(lineSamples + 0.5);
)";

// Each sample of the framebuffer is open if that sample of the lines is that lies where it lies.
const char* const WriteSamples = R"(
  int mask = 0;
  for (int i = 0; i < sampleCount; ++i)
  {
    mask |= ((open >> layerSample[i]) & 1) << i;
  }
  gl_SampleMask[0] = mask;
  gl_FragData[0] = lineColor;
}
)";

// With one sample in the framebuffer the lines have a share of what they have of the open ones.
const char* const WriteShare = R"(
  int count = 0;
  for (int i = 0; i < sampleCount; ++i)
  {
    count += (open >> i) & 1;
  }
  gl_FragData[0] = lineColor * (float(count) / float(sampleCount));
}
)";

void PointTo(vtkShaderProgram* program, const char* name, GLint components, GLenum type,
  GLboolean normalize, std::size_t offset)
{
  const auto location =
    static_cast<GLuint>(glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), name));
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, type, normalize,
    static_cast<GLsizei>(sizeof(vtkLimnCompositor::LinePixel)),
    reinterpret_cast<const void*>(offset));
}

bool CoversHalf(const vtkLimnCompositor::LinePixel& pixel)
{
  return pixel.Color[3] >= 128;
}
}

LinePainter::~LinePainter()
{
  if (this->Buffer == 0)
  {
    return;
  }
  this->Window->PushContext();
  glDeleteVertexArrays(1, &this->VertexArray);
  glDeleteBuffers(1, &this->Buffer);
  this->Window->PopContext();
}

void LinePainter::Forget()
{
  this->VertexArray = 0;
  this->Buffer = 0;
}

vtkShaderProgram* LinePainter::ReadyProgram(const vtkLimnCompositor::LineLayer& lines)
{
  const std::vector<SamplePoint> framebuffer = FramebufferSamplePoints();
  const bool hasMasks = !framebuffer.empty() && GLEW_ARB_sample_shading;
  const std::string fragment = std::string(BeginPixel) + (hasMasks ? WriteSamples : WriteShare);
  vtkShaderProgram* const program =
    this->Window->GetShaderCache()->ReadyShaderProgram(PlacePixel, fragment.c_str(), "");
  if (!program)
  {
    return nullptr;
  }
  const float size[2] = { static_cast<float>(lines.Width), static_cast<float>(lines.Height) };
  program->SetUniform2f("layerSize", size);
  program->SetUniformi("sampleCount", lines.Samples);
  if (hasMasks)
  {
    const std::vector<int> match = MatchSamples(LayerSamplePoints(lines.Samples), framebuffer);
    const int count = static_cast<int>(std::min<std::size_t>(match.size(), 32));
    program->SetUniformi("sampleCount", count);
    program->SetUniform1iv("layerSample", count, match.data());
  }
  return program;
}

void LinePainter::Upload(vtkShaderProgram* program)
{
  if (this->Buffer == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->Buffer);
  }
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->Pixels.size() * sizeof(Pixel)),
    this->Pixels.data(), GL_STREAM_DRAW);
  PointTo(program, "place", 2, GL_UNSIGNED_SHORT, GL_FALSE, offsetof(Pixel, X));
  PointTo(program, "color", 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Pixel, Color));
  PointTo(program, "depth", 1, GL_FLOAT, GL_FALSE, offsetof(Pixel, Depth));
  PointTo(program, "samples", 1, GL_UNSIGNED_BYTE, GL_FALSE, offsetof(Pixel, Samples));
}

void LinePainter::SetState()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_MULTISAMPLE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglPointSize(1.0f);
}

void LinePainter::Blend(const vtkLimnCompositor::LineLayer& lines)
{
  // Those that write their depth come again: as long as colours are mixed none may hide another.
  this->Pixels.assign(lines.Pixels, lines.Pixels + lines.Count);
  if (lines.WritesDepth)
  {
    std::copy_if(
      lines.Pixels, lines.Pixels + lines.Count, std::back_inserter(this->Pixels), CoversHalf);
  }
  const auto count = static_cast<GLsizei>(lines.Count);
  const auto deep = static_cast<GLsizei>(this->Pixels.size() - lines.Count);

  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable multisampleSaver(state, GL_MULTISAMPLE);
  vtkOpenGLState::ScopedglDepthFunc depthFuncSaver(state);
  vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
  vtkOpenGLState::ScopedglColorMask colorMaskSaver(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFuncSaver(state);
  // Of a pass that peels it is another one.
  GLint equation[2];
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equation[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equation[1]);
  this->SetState();
  if (vtkShaderProgram* const program = this->ReadyProgram(lines))
  {
    this->Upload(program);
    state->vtkglDepthMask(GL_FALSE);
    glDrawArrays(GL_POINTS, 0, count);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDrawArrays(GL_POINTS, count, deep);
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  state->vtkglBlendEquationSeparate(
    static_cast<GLenum>(equation[0]), static_cast<GLenum>(equation[1]));
}
