// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StyleMemory_h
#define StyleMemory_h

class vtkInformationDoubleKey;

namespace limn::bridge
{

/// The opacity that a vtkLimnProperty had before its first style, in its information.
vtkInformationDoubleKey* opacityBeforeStyles();

} // namespace limn::bridge

#endif
