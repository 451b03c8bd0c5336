// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliProblem_h
#define vtkHapticCliProblem_h

#include <stdexcept>

/// What a person has to change before the program can do its work: one line, exit code 2.
class vtkHapticCliProblem : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

#endif
