// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OpaqueOnly_h
#define OpaqueOnly_h

#include "Rendering/Scene.h"

#include "vtkWeakPointer.h"

#include <unordered_map>

class vtkActor;

namespace limn::bridge
{

class Complaints;

/// Complains of what only opaque surfaces have and a translucent actor asks for: of each such thing
/// once, and anew where the actor asks again after it did not.
class OpaqueOnly
{
public:
  /// Requires: the instance is the surface of the actor, which is about to be drawn.
  void look(vtkActor* actor, const Instance& instance, Complaints& complaints);

private:
  /// Of actors that are no more.
  void forgetDeleted();

  struct Said
  {
    vtkWeakPointer<vtkActor> actor; ///< its address may be another's by now
    unsigned causes;
  };
  std::unordered_map<vtkActor*, Said> said_;
};

} // namespace limn::bridge

#endif
