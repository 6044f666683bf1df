// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the textures of Data/Textures into the folder named on the command line.
#include "Data/Generator/GeneratedTextures.h"

#include <png.h>

#include <iostream>
#include <string>

namespace {

bool writePng(const limn::GeneratedTexture& texture, const std::string& path)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(texture.width);
  image.height = static_cast<png_uint_32>(texture.height);
  image.format = texture.components == 1   ? PNG_FORMAT_GRAY
                 : texture.components == 3 ? PNG_FORMAT_RGB
                                           : PNG_FORMAT_RGBA;
  // A negative stride: the lowest row comes last in the file.
  const int stride = -texture.width * texture.components;
  if (png_image_write_to_file(&image, path.c_str(), 0, texture.texels.data(), stride, nullptr) != 0)
    return true;
  std::cerr << "cannot write " << path << ": " << image.message << '\n';
  return false;
}

}  // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "usage: limn_generate_textures FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  bool isWritten = writePng(limn::uvGrid(), folder + "uv_grid.png");
  isWritten = writePng(limn::brickHeights(), folder + "brick_heights.png") && isWritten;
  isWritten = writePng(limn::brickNormals(), folder + "brick_normals.png") && isWritten;
  isWritten = writePng(limn::planet(), folder + "planet.png") && isWritten;
  isWritten = writePng(limn::leadedWindow(), folder + "leaded_window.png") && isWritten;
  isWritten = writePng(limn::toonRamp(), folder + "toon_ramp.png") && isWritten;
  isWritten = writePng(limn::litSphere(), folder + "lit_sphere.png") && isWritten;
  return isWritten ? 0 : 1;
}
