// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Binning/BinClusters.h"

#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <set>

namespace limn::testing {
namespace {

/// The tiles in which a cluster's triangles cover a sample when they are drawn alone.
std::set<std::size_t> tilesOf(const Scene& scene, const Instance& instance, const Cluster& cluster,
                              const Picture& size)
{
  const ClusteredMesh& mesh = *instance.clusters;
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < cluster.triangleCount; ++t)
    triangles.push_back(instance.mesh.triangles[mesh.triangle[cluster.firstTriangle + t]]);
  // Triangles without area keep the mesh's box, and so its way to the screen, as it was.
  for (const std::uint32_t triangle : mesh.triangle)
    for (const std::uint32_t v : instance.mesh.triangles[triangle].vertex)
      triangles.push_back({{v, v, v}});
  Instance alone = instance;
  alone.mesh.triangles = triangles;
  alone.attributes = {};
  alone.style = {};
  alone.style.normals = NormalSource::kTriangle;
  Scene single = scene;
  single.instances = {&alone, 1};

  Picture picture(size.width, size.height);
  const Status status = render(single, picture.frame(Background::kBlend), {Backend::kReference, 1});
  EXPECT_TRUE(status.ok()) << status.message;
  std::set<std::size_t> tiles;
  const TileGrid grid = {size.width, size.height};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (covered(picture, x, y)) tiles.insert(grid.index(x / kTileSide, y / kTileSide));
  return tiles;
}

TEST(BinClusters, AClusterIsListedInEachTileWhereItCoversASample)
{
  std::size_t found = 0;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    const RandomScene random(seed);
    const Picture size = random.canvas();
    const PlacedScene placed = placeScene(random.scene(), {size.width, size.height});
    TileBins bins;
    ASSERT_TRUE(binClusters(placed, 2, bins).ok());
    for (const PlacedInstance& here : placed.instances)
      for (std::size_t c = 0; c < here.mesh().clusters.size(); ++c)
        for (const std::size_t tile :
             tilesOf(random.scene(), *here.instance, here.mesh().clusters[c], size)) {
          const auto list = bins.clustersOf(tile);
          const auto number = static_cast<std::uint32_t>(here.firstCluster + c);
          ASSERT_EQ(std::count(list.begin(), list.end(), number), 1)
              << "cluster " << number << " tile " << tile << " seed " << seed;
          ++found;
        }
  }
  EXPECT_GT(found, 300u);
}

TEST(BinClusters, ListsDoNotDependOnTheNumberOfThreads)
{
  const RandomScene random(17);
  const PlacedScene placed = placeScene(random.scene(), {700, 500});
  const auto sortedLists = [&](int threads) {
    TileBins bins;
    EXPECT_TRUE(binClusters(placed, threads, bins).ok());
    std::vector<std::vector<std::uint32_t>> lists;
    for (std::size_t tile = 0; tile < bins.grid.count(); ++tile) {
      const auto list = bins.clustersOf(tile);
      lists.emplace_back(list.begin(), list.end());
      std::sort(lists.back().begin(), lists.back().end());
    }
    return lists;
  };
  const auto one = sortedLists(1);
  EXPECT_EQ(sortedLists(2), one);
  EXPECT_EQ(sortedLists(8), one);
}

TEST(BinClusters, WhatIsFarFromATileIsNotListedThere)
{
  // A sphere of 50 pixels in the middle of 12 x 10 tiles.
  Stage stage;
  stage.width = 768;
  stage.height = 640;
  stage.view.eye = {0, 0, 12};
  stage.view.far = 20;
  stage.instances = {painted(fineSphere(), {1, 1, 1})};
  const Scene scene = stage.scene();
  const PlacedScene placed = placeScene(scene, {stage.width, stage.height});
  TileBins bins;
  ASSERT_TRUE(binClusters(placed, 1, bins).ok());
  std::size_t filled = 0;
  for (std::size_t tile = 0; tile < bins.grid.count(); ++tile)
    filled += !bins.clustersOf(tile).empty();
  EXPECT_EQ(filled, 4u);
}

}  // namespace
}  // namespace limn::testing
