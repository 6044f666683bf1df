// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace limn {

inline constexpr std::size_t kHugePage = std::size_t{2} << 20;  ///< bytes

/// Asks the system to make memory that nobody has touched of huge pages: it is there after 512
/// times fewer page faults. Does nothing where the system knows none. `memory` starts such a page.
void preferHugePages(void* memory, std::size_t bytes);

}  // namespace limn
