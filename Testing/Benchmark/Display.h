// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Display_h
#define Display_h

/// Whether there is an X display to draw to; it is closed again.
bool IsDisplayOpen();

#endif
