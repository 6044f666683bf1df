// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Messages_h
#define limn_viewer_Messages_h

#include <string> // for messages

class vtkObject;

/// What VTK's classes report, in the form of the command line: one line each on stderr,
/// "limn: warning: ..." or "limn: error: ...", each distinct line once.
namespace limn::viewer
{

/// Makes VTK's warnings appear as they come, and its errors wait for throwCollectedErrors(). Call
/// once, before any VTK object is made.
void collectMessages();

/// If VTK reported errors since the last call: prints all but the last and throws the last as a
/// UserError. `subject`, if not empty, stands before each that does not name it: "teapot.vtp: no
/// such array".
void throwCollectedErrors(const std::string& subject = {});

/// Puts the file's name before messages of the object that do not name it.
void nameFileOf(vtkObject& object, const std::string& file);

void printWarning(const std::string& message);
void printError(const std::string& message);

} // namespace limn::viewer

#endif
