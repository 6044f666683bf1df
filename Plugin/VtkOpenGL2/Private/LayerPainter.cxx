// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LayerPainter.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtk_glew.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace
{
// With one sample on both sides. Only what shows nothing has no opacity.
const char* const CopyPixel = R"(
//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform vec2 layerSize;
uniform sampler2D colorPlane;
uniform sampler2D depthPlane;
void main()
{
  ivec2 pixel = ivec2(texCoord * layerSize);
  vec4 color = texelFetch(colorPlane, pixel, 0);
  if (color.a == 0.0)
  {
    discard;
  }
  gl_FragDepth = texelFetch(depthPlane, pixel, 0).r;
  gl_FragData[0] = color;
}
)";

// Fragments of nothing are discarded, so the rest of the picture and its depth stay as they are.
const char* const FetchPixel = R"(
//VTK::System::Dec
#extension GL_ARB_sample_shading : enable
//VTK::Output::Dec
in vec2 texCoord;
uniform vec2 layerSize;
uniform vec4 touched;
uniform sampler2D colorPlane;
uniform sampler2D depthPlane;
uniform sampler2D coveragePlane;
uniform int sampleCount;
uniform int layerSample[32];
void main()
{
  ivec2 pixel = ivec2(texCoord * layerSize);
  // The textures are old outside. A scissor box alone lets samples of the next column through when
  // llvmpipe multisamples.
  if (any(lessThan(vec2(pixel), touched.xy)) || any(greaterThanEqual(vec2(pixel), touched.zw)))
  {
    discard;
  }
  int covered = int(texelFetch(coveragePlane, pixel, 0).r * 255.0 + 0.5);
  if (covered == 0)
  {
    discard;
  }
  vec4 color = texelFetch(colorPlane, pixel, 0);
  gl_FragDepth = texelFetch(depthPlane, pixel, 0).r;
)";

// Each sample of the framebuffer follows the layer's sample that lies where it lies.
const char* const WriteSamples = R"(
  int mask = 0;
  for (int i = 0; i < sampleCount; ++i)
  {
    mask |= ((covered >> layerSample[i]) & 1) << i;
  }
  gl_SampleMask[0] = mask;
  gl_FragData[0] = color;
}
)";

// With one sample in the framebuffer, the share of the covered ones becomes opacity.
const char* const WriteShare = R"(
  int count = 0;
  for (int i = 0; i < sampleCount; ++i)
  {
    count += (covered >> i) & 1;
  }
  gl_FragData[0] = vec4(color.rgb, float(count) / float(sampleCount));
}
)";

// The same for colours that are multiplied by alpha.
const char* const WriteShareOfBlended = R"(
  int count = 0;
  for (int i = 0; i < sampleCount; ++i)
  {
    count += (covered >> i) & 1;
  }
  gl_FragData[0] = color * (float(count) / float(sampleCount));
}
)";

struct Rectangle
{
  int X;
  int Y;
  int Width;
  int Height;
};

Rectangle TouchedRectangle(const vtkLimnCompositor::Layer& layer)
{
  const int x0 = std::max(layer.Touched[0], 0);
  const int y0 = std::max(layer.Touched[1], 0);
  const int x1 = std::min(layer.Touched[2], layer.Width);
  const int y1 = std::min(layer.Touched[3], layer.Height);
  return { x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0) };
}

/// Makes all drawing touch only pixels of `wanted` (relative to the viewport) that the caller's own
/// scissor box lets through.
void NarrowScissor(vtkOpenGLState* state, const Rectangle& wanted)
{
  GLint viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  int x0 = viewport[0] + wanted.X;
  int y0 = viewport[1] + wanted.Y;
  int x1 = x0 + wanted.Width;
  int y1 = y0 + wanted.Height;
  if (state->GetEnumState(GL_SCISSOR_TEST))
  {
    GLint box[4];
    state->vtkglGetIntegerv(GL_SCISSOR_BOX, box);
    x0 = std::max(x0, box[0]);
    y0 = std::max(y0, box[1]);
    x1 = std::min(x1, box[0] + box[2]);
    y1 = std::min(y1, box[1] + box[3]);
  }
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0));
}
}

LayerPainter::Plane::Plane(vtkOpenGLRenderWindow* window, int components, int vtkType)
  : Components(components), VtkType(vtkType)
{
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
}

bool LayerPainter::Plane::Reserve(int width, int height)
{
  const unsigned int wantedWidth = static_cast<unsigned int>(width);
  const unsigned int wantedHeight = static_cast<unsigned int>(height);
  if (this->Texture->GetWidth() >= wantedWidth && this->Texture->GetHeight() >= wantedHeight)
  {
    return true;
  }
  const unsigned int grownWidth = std::max(wantedWidth, this->Texture->GetWidth());
  const unsigned int grownHeight = std::max(wantedHeight, this->Texture->GetHeight());
  const unsigned int limit =
    static_cast<unsigned int>(vtkTextureObject::GetMaximumTextureSize(this->Texture->GetContext()));
  if (grownWidth > limit || grownHeight > limit)
  {
    return false;
  }
  this->Texture->ResetFormatAndType();
  while (glGetError() != GL_NO_ERROR)
  {
    // Errors of others must not be taken for a refusal.
  }
  this->Texture->Allocate2D(grownWidth, grownHeight, this->Components, this->VtkType);
  if (glGetError() != GL_NO_ERROR)
  {
    this->Texture->ReleaseGraphicsResources(this->Texture->GetContext());
    return false;
  }
  return true;
}

void LayerPainter::Plane::Upload(const vtkLimnCompositor::Layer& layer, const void* pixels)
{
  const Rectangle touched = TouchedRectangle(layer);
  const std::size_t pixelBytes =
    static_cast<std::size_t>(this->Components) *
    (this->VtkType == VTK_FLOAT ? sizeof(float) : sizeof(unsigned char));
  const std::size_t firstPixel =
    static_cast<std::size_t>(touched.Y) * static_cast<std::size_t>(layer.Width) +
    static_cast<std::size_t>(touched.X);
  const unsigned char* first = static_cast<const unsigned char*>(pixels) + firstPixel * pixelBytes;

  this->Texture->Activate();
  glTexSubImage2D(GL_TEXTURE_2D, 0, touched.X, touched.Y, touched.Width, touched.Height,
    this->Texture->GetFormat(this->VtkType, this->Components, false),
    static_cast<GLenum>(this->Texture->GetDataType(this->VtkType)), first);
}

LayerPainter::LayerPainter(vtkOpenGLRenderWindow* window)
  : Window(window), Color(window, 4, VTK_UNSIGNED_CHAR), Depth(window, 1, VTK_FLOAT),
    Coverage(window, 1, VTK_UNSIGNED_CHAR), Lines(window)
{
}

LayerPainter::~LayerPainter()
{
  this->ForgetLostContext();
}

bool LayerPainter::Paint(const vtkLimnCompositor::Layer& layer)
{
  return this->Paint(layer, Way::TestDepth);
}

bool LayerPainter::Blend(const vtkLimnCompositor::Layer& layer)
{
  return this->Paint(layer, Way::Blend);
}

bool LayerPainter::Paint(const vtkLimnCompositor::Layer& layer, Way way)
{
  const Rectangle touched = TouchedRectangle(layer);
  if (touched.Width == 0 || touched.Height == 0)
  {
    return true;
  }
  if (!this->Reserve(layer))
  {
    return false;
  }
  const std::vector<SamplePoint> framebuffer = FramebufferSamplePoints();
  const Mix mix = !framebuffer.empty() && GLEW_ARB_sample_shading ? Mix::Masks
                  : layer.Samples > 1                             ? Mix::Share
                                                                  : Mix::None;
  this->Upload(layer, mix);
  this->Draw(layer, mix, way, framebuffer);
  this->Color.Texture->Deactivate();
  this->Depth.Texture->Deactivate();
  this->Coverage.Texture->Deactivate();
  return true;
}

void LayerPainter::BlendLines(const vtkLimnCompositor::LineLayer& lines)
{
  this->ForgetLostContext();
  // Whoever draws without a layer needs a texture, too, that tells when its context is lost.
  if (this->Color.Reserve(1, 1))
  {
    this->Lines.Blend(lines);
  }
}

void LayerPainter::ForgetLostContext()
{
  // A window that lost its context has released the textures; the programs went with its cache.
  if (!this->Color.IsAllocated())
  {
    this->Quads.clear();
    this->Lines.Forget();
  }
}

bool LayerPainter::Reserve(const vtkLimnCompositor::Layer& layer)
{
  this->ForgetLostContext();
  return this->Color.Reserve(layer.Width, layer.Height) &&
         this->Depth.Reserve(layer.Width, layer.Height) &&
         this->Coverage.Reserve(layer.Width, layer.Height);
}

void LayerPainter::Upload(const vtkLimnCompositor::Layer& layer, Mix mix)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, layer.Width);
  this->Color.Upload(layer, layer.Color);
  this->Depth.Upload(layer, layer.Depth);
  if (mix != Mix::None)
  {
    this->Coverage.Upload(layer, layer.Coverage);
  }
  state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

vtkOpenGLQuadHelper& LayerPainter::ReadyQuad(Mix mix, Way way)
{
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[{ mix, way }];
  if (!quad)
  {
    const char* const write = mix == Mix::Masks       ? WriteSamples
                              : way == Way::TestDepth ? WriteShare
                                                      : WriteShareOfBlended;
    const std::string shader =
      mix == Mix::None ? std::string(CopyPixel) : std::string(FetchPixel) + write;
    quad.reset(new vtkOpenGLQuadHelper(this->Window, nullptr, shader.c_str(), nullptr));
  }
  else
  {
    this->Window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  }
  return *quad;
}

void LayerPainter::SetState(Mix mix, Way way)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_MULTISAMPLE);
  if (way == Way::Blend)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    state->vtkglBlendEquation(GL_FUNC_ADD);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    return;
  }
  state->SetEnumState(GL_BLEND, mix == Mix::Share);
  state->vtkglBlendFuncSeparate(
    GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
}

void LayerPainter::Draw(const vtkLimnCompositor::Layer& layer, Mix mix, Way way,
  const std::vector<SamplePoint>& framebuffer)
{
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable multisampleSaver(state, GL_MULTISAMPLE);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglDepthFunc depthFuncSaver(state);
  vtkOpenGLState::ScopedglDepthMask depthMaskSaver(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFuncSaver(state);
  // Of a pass that peels it is another one.
  GLint equation[2];
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equation[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &equation[1]);
  this->SetState(mix, way);
  NarrowScissor(state, TouchedRectangle(layer));

  vtkOpenGLQuadHelper& quad = this->ReadyQuad(mix, way);
  const float size[2] = { static_cast<float>(layer.Width), static_cast<float>(layer.Height) };
  quad.Program->SetUniform2f("layerSize", size);
  quad.Program->SetUniformi("colorPlane", this->Color.Texture->GetTextureUnit());
  quad.Program->SetUniformi("depthPlane", this->Depth.Texture->GetTextureUnit());
  if (mix != Mix::None)
  {
    const Rectangle rectangle = TouchedRectangle(layer);
    const float touched[4] = { static_cast<float>(rectangle.X), static_cast<float>(rectangle.Y),
      static_cast<float>(rectangle.X + rectangle.Width),
      static_cast<float>(rectangle.Y + rectangle.Height) };
    quad.Program->SetUniform4f("touched", touched);
    quad.Program->SetUniformi("coveragePlane", this->Coverage.Texture->GetTextureUnit());
    quad.Program->SetUniformi("sampleCount", layer.Samples);
  }
  if (mix == Mix::Masks)
  {
    const std::vector<int> match = MatchSamples(LayerSamplePoints(layer.Samples), framebuffer);
    const int count = static_cast<int>(std::min<std::size_t>(match.size(), 32));
    quad.Program->SetUniformi("sampleCount", count);
    quad.Program->SetUniform1iv("layerSample", count, match.data());
  }
  quad.Render();
  state->vtkglBlendEquationSeparate(
    static_cast<GLenum>(equation[0]), static_cast<GLenum>(equation[1]));
}
