// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scaling_h
#define Scaling_h

#include <nlohmann/json.hpp>

/// How the cost of a frame grows with triangles, pixels, samples, actors and threads, each with the
/// rest held still: a list of charts, each with lines of points (x, milliseconds). A point is the
/// fastest of some frames, which tells more of the program and less of the machine's other work.
nlohmann::json MeasureScaling();

#endif
