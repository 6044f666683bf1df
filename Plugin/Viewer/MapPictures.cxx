// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MapPictures.h"

#include "Messages.h"

#include "vtkLimnRenderWindow.h"

#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cmath>

namespace limn::viewer
{
namespace
{

vtkSmartPointer<vtkImageData> emptyPicture(vtkLimnRenderWindow& window, int type, int channels)
{
  const int* const size = window.GetSize();
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  picture->AllocateScalars(type, channels);
  return picture;
}

/// The corners of the window, as its functions take them.
struct Corners
{
  int right, top;

  explicit Corners(vtkLimnRenderWindow& window)
    : right(window.GetSize()[0] - 1), top(window.GetSize()[1] - 1)
  {
  }
};

} // namespace

vtkSmartPointer<vtkImageData> pictureOfNormals(vtkLimnRenderWindow& window)
{
  const Corners corners(window);
  vtkNew<vtkFloatArray> normals;
  window.GetNormalData(0, 0, corners.right, corners.top, normals);
  throwCollectedErrors();
  auto picture = emptyPicture(window, VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < normals->GetNumberOfValues(); ++i)
  {
    const float share = normals->GetValue(i) * 0.5f + 0.5f;
    bytes[i] = static_cast<unsigned char>(std::floor(share * 255.0f + 0.5f));
  }
  return picture;
}

vtkSmartPointer<vtkImageData> pictureOfDepth(vtkLimnRenderWindow& window)
{
  const Corners corners(window);
  vtkNew<vtkFloatArray> depths;
  window.GetZbufferData(0, 0, corners.right, corners.top, depths);
  throwCollectedErrors();
  auto picture = emptyPicture(window, VTK_UNSIGNED_SHORT, 1);
  auto* const greys = static_cast<unsigned short*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < depths->GetNumberOfValues(); ++i)
  {
    // In double: 65535 times a float near 1 has no room for the half.
    greys[i] = static_cast<unsigned short>(std::floor(depths->GetValue(i) * 65535.0 + 0.5));
  }
  return picture;
}

vtkSmartPointer<vtkImageData> pictureOfIds(vtkLimnRenderWindow& window)
{
  const Corners corners(window);
  vtkNew<vtkIdTypeArray> ids;
  window.GetIdData(0, 0, corners.right, corners.top, ids);
  throwCollectedErrors();
  auto picture = emptyPicture(window, VTK_UNSIGNED_SHORT, 3);
  auto* const colors = static_cast<unsigned short*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const vtkIdType actor = ids->GetTypedComponent(i, 0);
    const vtkIdType cell = actor < 0 ? 0 : ids->GetTypedComponent(i, 1);
    colors[3 * i] = static_cast<unsigned short>(actor + 1);
    colors[3 * i + 1] = static_cast<unsigned short>(cell >> 16);
    colors[3 * i + 2] = static_cast<unsigned short>(cell & 0xFFFF);
  }
  return picture;
}

} // namespace limn::viewer
