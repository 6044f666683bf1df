// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ChainEdges.h"
#include "Rendering/Mesh/BuildClusters.h"
#include "Rendering/Mesh/FaceGeometry.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Rendering/Renderer.h"
#include "Rendering/SurfaceShader.h"

#include <array>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace limn::testing {

/// Uniform numbers that are the same on every platform; std's distributions are not.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t below(std::uint32_t end) { return next() % end; }
  bool chance(int oneIn) { return below(static_cast<std::uint32_t>(oneIn)) == 0; }
  double between(double low, double high) { return low + (high - low) * (next() / 4294967296.0); }
  Vec3d inBox(double half)
  {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  Vec3f color() { return vec3Cast<float>(inBox(0.5) + Vec3d{0.5, 0.5, 0.5}); }

 private:
  std::uint32_t next() { return static_cast<std::uint32_t>(engine_()); }

  std::mt19937 engine_;
};

/// A mesh with all that can be attached to one. Owns what an Instance borrows.
struct OwnedMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3d> precise;
  std::vector<Triangle> triangles;
  std::vector<Vec3f> vertexNormals, cellNormals;
  std::vector<Rgba8> vertexColors, cellColors;
  std::vector<Vec2f> uv, uv2;
  std::vector<std::uint32_t> cells, cellIds;
  std::size_t cellCount = 0;
  FaceGeometry faces;
  SplitNormals splitNormals;
  SmoothNormals smoothNormals;
  std::vector<Vec3d> firstCorners;
  ClusteredMesh clusters;
  HullEdges hull;

  MeshView view() const { return {positions, precise, triangles}; }
};

/// Planes of one picture.
struct Picture {
  int width, height;
  std::vector<Rgba8> color;
  std::vector<float> depth;
  std::vector<std::uint8_t> coverage;  ///< empty with 16 samples
  std::vector<std::uint32_t> instance, cell;
  std::array<std::vector<float>, 3> radiance;  ///< empty unless asked for
  std::array<std::vector<float>, 3> normal;    ///< likewise
  std::vector<LinePixel> linePixels;           ///< FrameView's, if a frame was given them

  Picture(int width, int height);
  FrameView frame(Background background);
  /// Of the colours that the picture has now.
  void addRadiance();
  void addNormals();
  /// By rows, for comparisons.
  void sortLinePixels();
  /// Pixels in which any plane differs, by bits.
  std::size_t differingPixels(const Picture& other) const;
};

/// A scene made from a number: every feature of Scene.h turns up, and so do the inputs that break
/// rasterizers: slivers, degenerate and coincident triangles, vertices behind the eye, huge and
/// tiny triangles, coordinates far from the origin, broken indices and NaN.
class RandomScene {
 public:
  enum class Detail {
    kAny,   ///< up to some hundred triangles of every kind
    kFine,  ///< closed, bumpy surfaces of ten thousands, which hide each other and their own backs
    kCoarse,       ///< some triangles that fill the picture, half of them matt, half with outlines
    kPost,         ///< kAny with bright lights and post effects
    kReflections,  ///< as kAny, with every reflection model and its values
    kTextures,     ///< as kAny or kCoarse, with textures of all kinds
    kLights,       ///< as kAny, with area lights, normals of corners, faces lit at a corner
    kShaders,      ///< as kTextures, with surface shaders and vertex shaders
    /// As kAny or kCoarse, most instances translucent, some with textures, 1 to 16 samples.
    kTranslucent,
    kFineTranslucent,  ///< likewise as kFine
    /// As kAny or kCoarse, with every tone and outline; some textured, translucent or programmed.
    kTones,
    kDataTones,    ///< as kAny or kCoarse, with tones over colours of data
    kHulls,        ///< closed surfaces, coarse or as kFine, with inverted hulls
    kLines,        ///< as kAny, kFine or kCoarse, with lines of all kinds
    kLineShares,   ///< as kLines, most of them wider and thinner from point to point
    kVeils,        ///< as kTranslucent, with lines, outlines from the picture and some depth cues
    kHatching,     ///< as kTones, with hatching alone
    kImageLines,   ///< as kAny, kFine or kCoarse, most with lines from the picture
    kCreases,      ///< likewise, by every way to find creases
    kIdBorders,    ///< likewise with ids of cells, most with borders between them
    kCues,         ///< likewise with depth cues, some with lines from the picture as well
    kExaggerated,  ///< as kTones, with exaggerated shading alone, half of it over colours of data
    kCreasedExaggeration,  ///< likewise with normals of scales that are apart at creases
  };
  explicit RandomScene(std::uint32_t seed, Detail detail = Detail::kAny);

  const Scene& scene() const { return scene_; }
  Background background() const { return background_; }
  /// None unless kPost.
  const PostEffects& effects() const { return effects_; }
  /// The picture before drawing: a background, and now and then old depths.
  Picture canvas() const;

 private:
  void addMesh(Random& random, Detail detail);
  void addAttributes(Random& random, OwnedMesh& mesh);
  Instance instanceOf(Random& random, const OwnedMesh& mesh, std::uint32_t id, Detail detail);
  // Of streams of their own: the other scenes stay as they are.
  void addReflections();
  void addLights();
  void addNormals(Random& random);
  void addTextures();
  void addTranslucency();
  void addTones();
  void addDataTones();
  void addHatching();
  void addExaggeration(Detail detail);
  void addHulls();
  void addShares();
  void addImageLines();
  void addCreaseDetectors();
  void addIds();
  void addCues();
  void joinTextures();
  void addImages(Random& random);
  TextureLayer randomLayer(Random& random) const;
  Style randomStyle(Random& random, const OwnedMesh& mesh);
  Light randomLight(Random& random);
  void placeCamera(Random& random);
  void addEffects(Random random);
  void addShaders(Random random);
  void addLines(Random random);

  std::uint32_t seed_;
  int width_, height_;
  Vec3d centre_;
  std::vector<std::unique_ptr<OwnedMesh>> meshes_;
  std::vector<std::unique_ptr<TextureImage>> images_;
  std::vector<ProceduralTexture> procedurals_;
  std::vector<std::vector<TextureLayer>> layers_;  ///< by instance
  std::vector<Instance> instances_;
  std::vector<std::unique_ptr<SurfaceShader>> shaders_;
  struct OwnedLines {
    LineChains chains;
    std::vector<float> slack, share;
  };
  std::vector<std::unique_ptr<OwnedLines>> chains_;
  std::vector<std::vector<LineSet>> lines_;  ///< by instance
  std::vector<Light> lights_;
  Scene scene_;
  Background background_;
  PostEffects effects_;
};

/// Of the scene on its canvas. Expects that it can be drawn.
Picture drawn(const RandomScene& random, const RenderOptions& options);

}  // namespace limn::testing
