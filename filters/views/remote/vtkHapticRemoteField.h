// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRemoteField_h
#define vtkHapticRemoteField_h

#include "vtkHapticFieldPacket.h"

class vtkSMSourceProxy;

/// Data of a server as a field: blocks are made there and fetched. The thread of ParaView's proxies alone may ask it.
struct vtkHapticRemoteFieldResult
{
  vtkHapticFieldResult Field;
  std::shared_ptr<const bool> Changed{}; ///< whether the source has made other data since
};

/// Of the output of a source at a port, at a time of the pipeline.
[[nodiscard]] vtkHapticRemoteFieldResult vtkHapticRemoteField(
  vtkSMSourceProxy* source, unsigned int port, double time, const vtkHapticFieldArrays& arrays);

/// Names of the arrays of numbers that data of a server have, as vtkHapticFieldArrayNames() says them of data here.
[[nodiscard]] std::vector<std::string> vtkHapticRemoteArrayNames(
  vtkSMSourceProxy* source, unsigned int port, int components);

#endif
