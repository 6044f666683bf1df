// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef KnownInput_h
#define KnownInput_h

#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkLimnPolyDataMapper;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkTrivialProducer;

namespace limn::bridge
{

/// A mapper's input that was set as data, while VTK's pipeline would find nothing to do for it.
/// Asking the pipeline takes microseconds each time, of which a frame of many actors has many.
class KnownInput
{
public:
  /// nullptr if the pipeline has to be asked: the mapper, its connection or the data were modified
  /// since remember(), or the input comes from a filter.
  vtkPolyData* get(vtkPolyDataMapper* mapper) const;

  /// Requires: the mapper has just been updated.
  void remember(vtkPolyDataMapper* mapper);

private:
  vtkWeakPointer<vtkTrivialProducer> producer_;
  vtkPolyData* data_ = nullptr; ///< held by the producer
  vtkMTimeType mapperTime_ = 0;
  vtkMTimeType producerTime_ = 0; ///< and of its data
};

/// As mapper->GetInput(), without asking the pipeline where the input is known.
vtkPolyData* inputOf(vtkLimnPolyDataMapper* mapper);

} // namespace limn::bridge

#endif
