// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpaqueOnly.h"

#include "Complaints.h"

#include "vtkActor.h"

#include <array>
#include <iterator>
#include <string>

namespace limn::bridge
{
namespace
{

struct Cause
{
  bool isAsked;
  const char* what;
  const char* instead; ///< of making the actor opaque
};

std::array<Cause, 4> causesOf(const Style& style)
{
  const bool hasOutline = style.imageOutline.detector != OutlineDetector::kNone &&
                          style.outlineWidth > 0 && style.outlineOpacity > 0;
  return { { { hasOutline, "outline by image", "Use SetOutlineToHull() or ContourLinesOn(), or" },
    { style.cues.eyeDome.strength > 0, "eye-dome lighting", "Turn it off, or" },
    { style.cues.unsharp.strength > 0, "depth unsharp mask", "Turn it off, or" },
    { style.cues.halo.width > 0, "halo", "Set its width to 0, or" } } };
}

} // namespace

void OpaqueOnly::look(vtkActor* actor, const Instance& instance, Complaints& complaints)
{
  const auto known = said_.find(actor);
  const unsigned before = known != said_.end() && known->second.actor ? known->second.causes : 0;
  unsigned now = 0;
  unsigned bit = 1;
  if (instance.isTranslucent())
  {
    for (const Cause& cause : causesOf(instance.style))
    {
      now |= cause.isAsked ? bit : 0;
      if ((now & ~before & bit) != 0)
      {
        complaints.add(
          actor, std::string("Its ") + cause.what +
                   " is not drawn: only opaque surfaces have one, and this actor is translucent. " +
                   cause.instead + " make the actor opaque.");
      }
      bit <<= 1;
    }
  }
  if (now != 0)
  {
    if (known == said_.end())
    {
      this->forgetDeleted();
    }
    said_[actor] = { actor, now };
  }
  else if (known != said_.end())
  {
    said_.erase(known);
  }
}

void OpaqueOnly::forgetDeleted()
{
  for (auto one = said_.begin(); one != said_.end();)
  {
    one = one->second.actor ? std::next(one) : said_.erase(one);
  }
}

} // namespace limn::bridge
