// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldBlock_h
#define vtkHapticFieldBlock_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <memory>

/**
 * The block of numbers around a hand, made where the data are.
 *
 * Clients that feel data of a server ask this filter there: of all data only the block travels, as the bytes of a
 * table's one column (vtkHapticFieldPacket.h). Data in pieces on several ranks are gathered once and after each change;
 * the first rank has the block.
 */
class VTKHAPTICPIPELINE_EXPORT vtkHapticFieldBlock : public vtkTableAlgorithm
{
public:
  static vtkHapticFieldBlock* New();
  vtkTypeMacro(vtkHapticFieldBlock, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Which arrays are felt, by name, "": none; as FieldArray, FieldVectors, FieldResistance, FieldOther of a session.
  void SetValues(const char* name);
  void SetDirections(const char* name);
  void SetResistance(const char* name);
  void SetOther(const char* name);
  ///@}

  ///@{
  /// As FieldComponent, FieldEigenvector and FieldSmoothing of a session.
  void SetComponent(int component);
  void SetEigenvector(int which);
  void SetSmoothing(int times);
  ///@}

  ///@{
  /// The place that the block is to be made around, how far it is to reach [u], and its number; number 0: no block is
  /// wanted, only whether the data can be felt.
  vtkSetVector3Macro(Centre, double);
  vtkSetMacro(Reach, double);
  vtkSetMacro(Revision, int);
  ///@}

  ///@{
  /// The value whose surface is felt, where one is.
  vtkSetMacro(Level, double);
  vtkSetMacro(HasLevel, bool);
  ///@}

  /// Whether smooth levels are felt: then it is looked up how steep the scalar is at most in all of the data.
  vtkSetMacro(SmoothLevels, bool);

  /// The bytes of an output; null where it is none of this filter.
  static class vtkUnsignedCharArray* BytesOf(vtkTable* output);

protected:
  vtkHapticFieldBlock();
  ~vtkHapticFieldBlock() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /// Changes the arrays: the data are looked at anew.
  template<class Change>
  void ChangeArrays(const Change& change);

  double Centre[3] = { 0.0, 0.0, 0.0 };
  double Reach = 0.0;
  int Revision = 0;
  double Level = 0.0;
  bool HasLevel = false;
  bool SmoothLevels = false;

  struct Looked;
  std::unique_ptr<Looked> Data;
};

#endif
