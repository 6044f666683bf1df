// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Picture_h
#define limn_viewer_Picture_h

#include <string> // for file names
#include <vector> // for pixels

class vtkImageData;

namespace limn::viewer
{

/// Throws UserError if `file` cannot become a file: its folder is missing, or it is a directory.
/// Lets long work fail before it starts.
void checkWritable(const std::string& file);

/// Writes `file` whole or not at all: a temporary file in the same folder is renamed. The bytes
/// depend on the picture only. Throws UserError if it cannot be written.
void writePicture(vtkImageData& picture, const std::string& file);

struct Picture
{
  int width = 0, height = 0;
  std::vector<unsigned char> rgba; ///< rows from the top; grey is spread, no alpha is opaque
};

/// Reads a PNG file of up to 8 bits per channel. Throws UserError if there is none.
Picture readPicture(const std::string& file);

} // namespace limn::viewer

#endif
