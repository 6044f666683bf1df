// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include "Measure.h"
#include "Scenes.h"

#include <nlohmann/json.hpp>

/// The figures of one scene. Times are milliseconds; ratios are against VTK's own mapper.
nlohmann::json ToJson(const Scene& scene, const SceneResult& result);

/// Prints a few lines of what ToJson() made.
void Print(const nlohmann::json& figures);

#endif
