// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Complaints_h
#define Complaints_h

#include <string>
#include <vector>

class vtkObject;

namespace limn::bridge
{

/// What is wrong with objects that are drawn together, for warnings: of several with one cause the
/// first is named, with its details, and the others are counted. Warns when it ends; the objects
/// have to be there until then.
class Complaints
{
public:
  Complaints() = default;
  ~Complaints();
  Complaints(const Complaints&) = delete;
  void operator=(const Complaints&) = delete;

  void add(vtkObject* object, const std::string& cause, const std::string& details = {});

private:
  struct Complaint
  {
    vtkObject* object;
    std::string cause, details;
    int others; ///< objects of which the same is said
  };
  std::vector<Complaint> all_;
};

} // namespace limn::bridge

#endif
