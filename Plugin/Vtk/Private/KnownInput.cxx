// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KnownInput.h"

#include "MapperInternals.h"

#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkTrivialProducer.h"

#include <cstring>

namespace limn::bridge
{

vtkPolyData* KnownInput::get(vtkPolyDataMapper* mapper) const
{
  const bool isKnown =
    producer_ && mapperTime_ == mapper->GetMTime() && producerTime_ == producer_->GetMTime();
  return isKnown ? data_ : nullptr;
}

void KnownInput::remember(vtkPolyDataMapper* mapper)
{
  vtkAlgorithm* const source = mapper->GetInputAlgorithm();
  // Classes derived from it may do more in an update.
  const bool isPlain = source && std::strcmp(source->GetClassName(), "vtkTrivialProducer") == 0;
  producer_ = isPlain ? static_cast<vtkTrivialProducer*>(source) : nullptr;
  if (isPlain)
  {
    data_ = mapper->GetInput();
    mapperTime_ = mapper->GetMTime();
    producerTime_ = producer_->GetMTime();
  }
}

vtkPolyData* inputOf(vtkLimnPolyDataMapper* mapper)
{
  vtkPolyData* const known = mapper->GetInternals().Input.get(mapper);
  return known ? known : mapper->GetInput();
}

} // namespace limn::bridge
