// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticAskedField_h
#define vtkHapticAskedField_h

#include <string>
#include <vector>

#include "vtkHapticFieldData.h"
#include "vtkHapticViewScan.h"

class vtkHapticSession;
class vtkSMProxy;

/// Whether a session names any array in space to feel.
bool vtkHapticAsksForField(const vtkHapticSession& session);

/// Names of the arrays of numbers that a source has, here or on a server: vtkHapticFieldArrayNames().
std::vector<std::string> vtkHapticArraysOfSource(const vtkHapticViewScan::Source& source, int components = 0);

/// The sources whose arrays may be felt: the one that the session names, shown or not, else those that `shown` has.
/// None where a source of that name has no data here.
std::vector<vtkHapticViewScan::Source> vtkHapticSourcesOfField(
  const vtkHapticSession& session, vtkSMProxy* view, const std::vector<vtkHapticViewScan::Source>& shown);

struct vtkHapticFieldCandidates
{
  std::vector<vtkHapticViewScan::Source>
    Sources;           ///< that have all arrays, are to be touched and lie where they are drawn
  std::string Refusal; ///< why there is none, where somebody asks for one
};
vtkHapticFieldCandidates vtkHapticCandidatesOfField(
  const vtkHapticSession& session, vtkSMProxy* view, const std::vector<vtkHapticViewScan::Source>& shown);

/// Detects whether a source has new output.
struct vtkHapticFieldKey
{
  const void* Made = nullptr; ///< the data, or their source on a server
  unsigned int Port = 0;
  double Time = 0.0; ///< of their last change, or of the pipeline on a server
  friend bool operator==(const vtkHapticFieldKey&, const vtkHapticFieldKey&) = default;
};
vtkHapticFieldKey vtkHapticKeyOfField(const vtkHapticViewScan::Source& source, vtkSMProxy* view);

/// The request of the session.
vtkHapticFieldArrays vtkHapticArraysOfSession(const vtkHapticSession& session);

#endif
