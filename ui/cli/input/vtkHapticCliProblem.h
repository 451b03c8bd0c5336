// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCliProblem_h
#define vtkHapticCliProblem_h

#include <iostream>
#include <stdexcept>
#include <string>

/// A problem that a person has to solve before the program can do its work: one line, exit code 2.
class vtkHapticCliProblem : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A line for a person to know of, on stderr; nothing for "". `file`: its subject; "": none by a name.
inline void vtkHapticCliNote(const std::string& file, const std::string& note)
{
  if (!note.empty())
  {
    std::cerr << "palpate: " << file << (file.empty() ? "" : ": ") << note << '\n';
  }
}

#endif
