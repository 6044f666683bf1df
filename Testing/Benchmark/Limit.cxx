// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Limit.h"

#include "Bandwidth.h"
#include "Stopwatch.h"

#include "Rendering/Base/Executor.h"
#include "Rendering/Base/FloatMode.h"
#include "Rendering/Binning/BinClusters.h"
#include "Rendering/Binning/BoundClusters.h"
#include "Rendering/Post/ResolveTile.h"
#include "Rendering/Raster/VisibilityTile.h"
#include "Rendering/Shading/Fragments.h"
#include "Rendering/Vertex/PlacedScene.h"

#include <algorithm>
#include <atomic>
#include <bitset>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace
{
using namespace limn;

/// The first run brings the data into the caches. Milliseconds.
template <class Prepare, class Work>
double BestTime(Prepare prepare, Work work)
{
  constexpr int kRuns = 3;
  double best = std::numeric_limits<double>::max();
  for (int run = 0; run < kRuns; ++run)
  {
    prepare();
    const Stopwatch time;
    work();
    best = std::min(best, time.Milliseconds());
  }
  return best;
}

template <class Work>
double BestTime(Work work)
{
  return BestTime([] {}, work);
}

/// What is known of a cluster over all tiles.
struct Seen
{
  std::atomic<bool> IsSifted[2] = { false, false }; ///< by Choice
  std::atomic<std::uint64_t> Vertices = 0;          ///< bit per vertex of a triangle seen
};

enum Choice
{
  kFull,
  kOracle
};

/// Replays the tiles of one frame.
class Replay
{
public:
  Replay(const ReplayedFrame& replayed, std::vector<Rgba8>& color)
    : Threads(replayed.Threads), Samples(replayed.Scene.samples),
      Placed(placeScene(replayed.Scene, { replayed.Width, replayed.Height }, NoCulling())),
      Of(this->Placed.clusterCount),
      Depth(static_cast<std::size_t>(replayed.Width) * replayed.Height, 1.0f)
  {
    color.assign(this->Depth.size(), Rgba8{ 0, 0, 0, 0 });
    this->Frame.width = replayed.Width;
    this->Frame.height = replayed.Height;
    this->Frame.rowStride = replayed.Width;
    this->Frame.color = color.data();
    this->Frame.depth = this->Depth.data();
    if (const Status status = binClusters(this->Placed, this->Threads, this->Bins); !status.ok())
    {
      throw std::runtime_error(status.message);
    }
  }

  Limit Run()
  {
    this->Result.Threads = this->Threads;
    this->Result.PictureBytes = 8.0 * this->Depth.size();
    this->TimeBounds();
    parallelFor(this->Threads, this->Bins.grid.count(),
      [this](std::size_t tile)
      {
        if (!this->Bins.clustersOf(tile).empty())
        {
          this->ReplayTile(tile);
        }
      });
    this->CountBytes();
    return this->Result;
  }

private:
  static Optimizations NoCulling()
  {
    Optimizations optimizations;
    optimizations.occlusionCulling = false;
    return optimizations;
  }

  void TimeBounds()
  {
    constexpr std::size_t kChunk = 256;
    std::vector<ClusterBounds> bounds(kChunk);
    for (const PlacedInstance& placed : this->Placed.instances)
    {
      const BoundsTransform transform(placed.transform.toClip);
      const std::vector<Cluster>& clusters = placed.mesh().clusters;
      for (std::size_t first = 0; first < clusters.size(); first += kChunk)
      {
        const Span<const Cluster> chunk = { clusters.data() + first,
          std::min(kChunk, clusters.size() - first) };
        this->Result.Bound += BestTime(
          [&] {
            boundClusters(
              transform, chunk, { this->Frame.width, this->Frame.height }, bounds.data());
          });
      }
    }
  }

  std::uint32_t NumberOf(const PlacedCluster& cluster) const
  {
    return cluster.placed->firstCluster +
           static_cast<std::uint32_t>(cluster.cluster - cluster.placed->mesh().clusters.data());
  }

  void Clear(const TileRectangle& pixels, VisibilityTile& tile) const
  {
    clearTile(this->Frame, pixels, this->Samples, tile);
  }

  /// Adds the times of drawing clusters of one tile. A cluster that meets more tiles is sifted in
  /// each, but only once of necessity.
  void TimeClusters(const std::vector<TileCluster>& list, const TileRectangle& pixels,
    Choice choice, VisibilityTile& scratch, Floor& floor)
  {
    // Small enough that a group, and the tile, stay in the caches.
    constexpr std::size_t kGroup = 16;
    const TileRectangle nothing = { pixels.x0, pixels.y0, pixels.x0, pixels.y0 };
    std::vector<TileCluster> fresh, repeated;
    for (const TileCluster& cluster : list)
    {
      const bool isRepeated =
        this->Of[this->NumberOf(cluster.cluster)].IsSifted[choice].exchange(true);
      (isRepeated ? repeated : fresh).push_back(cluster);
    }
    const auto clear = [&] { this->Clear(pixels, scratch); };
    for (const std::vector<TileCluster>* clusters : { &fresh, &repeated })
    {
      for (std::size_t first = 0; first < clusters->size(); first += kGroup)
      {
        const TileClusters group = { &this->Placed,
          { clusters->data() + first, std::min(kGroup, clusters->size() - first) } };
        const double all =
          BestTime(clear, [&] { rasterizeTile(group, pixels, this->Samples, scratch); });
        const double sift =
          BestTime(clear, [&] { rasterizeTile(group, nothing, this->Samples, scratch); });
        floor.Sift += clusters == &fresh ? sift : 0;
        floor.Cover += std::max(all - sift, 0.0);
      }
    }
    for (const TileCluster& cluster : fresh)
    {
      ++floor.Clusters;
      floor.Triangles += cluster.bounds.triangleCount;
      const double position = cluster.cluster.mesh().hasLowParts() ? 24 : 12;
      floor.GeometryBytes +=
        position * cluster.bounds.vertexCount + 3.0 * cluster.bounds.triangleCount;
    }
  }

  /// Those of which a sample of the tile shows something, whose vertices are noted.
  std::vector<TileCluster> SeenOf(const TileClusters& clusters, const FragmentList& fragments)
  {
    std::vector<std::uint64_t> vertices(clusters.list.size(), 0);
    const auto note = [&](std::uint32_t owner)
    {
      const std::uint32_t slot = TileOwner::slot(owner);
      const std::uint32_t triangle = TileOwner::triangle(owner);
      for (int k = 0; k < 3; ++k)
      {
        vertices[slot] |= std::uint64_t{ 1 } << clusters.at(slot).corner(triangle, k);
      }
    };
    std::for_each_n(fragments.owner.begin(), fragments.count, note);
    std::for_each_n(fragments.triangleOwner.begin(), fragments.triangleCount, note);
    std::vector<TileCluster> seen;
    for (std::size_t slot = 0; slot < vertices.size(); ++slot)
    {
      if (vertices[slot] != 0)
      {
        seen.push_back(clusters.list[slot]);
        this->Of[this->NumberOf(clusters.list[slot].cluster)].Vertices |= vertices[slot];
      }
    }
    return seen;
  }

  void ReplayTile(std::size_t tile)
  {
    const TileRectangle pixels = this->Bins.grid.rectangle(tile);
    std::vector<TileCluster> ordered;
    orderClusters(this->Placed, this->Bins, tile, ordered);
    const TileClusters clusters = { &this->Placed, ordered };
    const auto visible = std::make_unique<VisibilityTile>();
    FragmentList fragments;
    const auto colors = std::make_unique<TileColors>();
    alignas(64) Rgba8 runColor[kTilePixels];
    colors->pixel = runColor;
    FragmentShader shader;

    Limit part;
    part.Resolve += BestTime([&] { this->Clear(pixels, *visible); });
    rasterizeTile(clusters, pixels, this->Samples, *visible);
    part.Shade += BestTime(
      [&]
      {
        collectFragments(*visible, pixels, this->Samples, Optimizations().fragmentRuns, fragments);
        shader.shade(clusters, pixels, this->Samples, fragments, *colors);
      });
    const std::vector<TileCluster> seen = this->SeenOf(clusters, fragments);
    const auto scratch = std::make_unique<VisibilityTile>();
    this->TimeClusters(ordered, pixels, kFull, *scratch, part.Full);
    this->TimeClusters(seen, pixels, kOracle, *scratch, part.Oracle);
    // Last, as it changes the frame.
    const auto resolve = [&]
    { resolveTile(clusters, *visible, pixels, fragments, *colors, this->Frame); };
    part.Resolve += this->TimeResolve(pixels, resolve);
    part.Fragments = fragments.count;
    std::for_each_n(fragments.run.begin(), fragments.runCount,
      [&](const FragmentRun& run) { part.Fragments += run.length; });

    const std::lock_guard<std::mutex> lock(this->ResultMutex);
    this->Add(part);
  }

  /// Each time over an empty picture, with which samples that show nothing are mixed.
  template <class Resolve>
  double TimeResolve(const TileRectangle& pixels, Resolve resolve)
  {
    const auto empty = [&]
    {
      for (int y = pixels.y0; y < pixels.y1; ++y)
      {
        std::fill(this->Frame.color + y * this->Frame.rowStride + pixels.x0,
          this->Frame.color + y * this->Frame.rowStride + pixels.x1, Rgba8{ 0, 0, 0, 0 });
      }
    };
    return BestTime(empty, resolve);
  }

  void Add(const Limit& part)
  {
    this->Result.Shade += part.Shade;
    this->Result.Resolve += part.Resolve;
    this->Result.Fragments += part.Fragments;
    ++this->Result.Tiles;
    this->Result.LargestTile = std::max(
      this->Result.LargestTile, part.Oracle.Sift + part.Oracle.Cover + part.Shade + part.Resolve);
    for (Floor Limit::*member : { &Limit::Full, &Limit::Oracle })
    {
      Floor& sum = this->Result.*member;
      const Floor& more = part.*member;
      sum.Clusters += more.Clusters;
      sum.Triangles += more.Triangles;
      sum.GeometryBytes += more.GeometryBytes;
      sum.Sift += more.Sift;
      sum.Cover += more.Cover;
    }
  }

  void CountBytes()
  {
    const double boxes = static_cast<double>(sizeof(Cluster)) * this->Placed.clusterCount;
    this->Result.Full.GeometryBytes += boxes;
    this->Result.Oracle.GeometryBytes += boxes;
    for (const PlacedInstance& placed : this->Placed.instances)
    {
      const bool hasNormals = placed.instance->style.normals == NormalSource::kVertex;
      const double perVertex = sizeof(std::uint32_t) + (hasNormals ? sizeof(Vec3f) : 0);
      for (std::size_t c = 0; c < placed.mesh().clusters.size(); ++c)
      {
        const std::bitset<kMaxClusterVertices> seen(this->Of[placed.firstCluster + c].Vertices);
        this->Result.AttributeBytes += perVertex * static_cast<double>(seen.count());
      }
    }
  }

  int Threads;
  int Samples;
  PlacedScene Placed;
  std::vector<Seen> Of;
  std::vector<float> Depth;
  FrameView Frame;
  TileBins Bins;
  std::mutex ResultMutex;
  Limit Result;
};
}

double Limit::MemoryMilliseconds(const Floor& floor) const
{
  return (floor.GeometryBytes + this->AttributeBytes) / floor.ReadBytesPerMillisecond +
         this->PictureBytes / this->WriteBytesPerMillisecond;
}

double Limit::ProcessorMilliseconds(const Floor& floor) const
{
  return (this->Bound + floor.Sift + floor.Cover + this->Shade + this->Resolve) / this->Threads;
}

double Limit::Milliseconds(const Floor& floor) const
{
  return std::max(this->MemoryMilliseconds(floor), this->ProcessorMilliseconds(floor));
}

Limit MeasureLimit(const ReplayedFrame& frame, std::vector<limn::Rgba8>& color)
{
  const limn::FloatMode mode;
  Limit limit = Replay(frame, color).Run();
  limit.WriteBytesPerMillisecond = Bandwidth::OfWriting(limit.PictureBytes, limit.Threads);
  for (Floor* floor : { &limit.Full, &limit.Oracle })
  {
    floor->ReadBytesPerMillisecond = Bandwidth::OfReading(floor->GeometryBytes, limit.Threads);
  }
  return limit;
}
