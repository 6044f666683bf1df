// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_MapPictures_h
#define limn_viewer_MapPictures_h

#include <vtkSmartPointer.h> // for pictures

class vtkImageData;
class vtkLimnRenderWindow;

/// Pictures of what a frame keeps besides colours. All require a window that was rendered with Maps
/// on, and have rows from below, as VTK's images have.
namespace limn::viewer
{

/// Three bytes a pixel: view-space normals by round(255 (n + 1) / 2), as maps of normals have it;
/// (128, 128, 128) where nothing is seen.
vtkSmartPointer<vtkImageData> pictureOfNormals(vtkLimnRenderWindow& window);
/// 16 bits of grey: window depth by round(65535 depth), 0 at the near plane, 65535 where nothing is
/// seen.
vtkSmartPointer<vtkImageData> pictureOfDepth(vtkLimnRenderWindow& window);
/// Three times 16 bits: red is the number of the mesh, from 1 on in the order of the command line;
/// green 65536 + blue is the cell. Black where nothing is seen.
vtkSmartPointer<vtkImageData> pictureOfIds(vtkLimnRenderWindow& window);

} // namespace limn::viewer

#endif
