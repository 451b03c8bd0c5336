// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticTouchAs
 * @brief   sets a session so that a source of the pipeline is touched as a kind of thing that is named
 *
 * The kinds are "surface", "lines", "field", "tool", "tissue", "mechanism" and "not at all". Each sets the properties
 * of the session's proxy that the rows of the panel set, so traces, undo steps and state files have them, and shows or
 * hides the source in the view as that kind needs. A source is of one kind at a time; the hand holds one thing.
 *
 *     touch = vtkHapticTouchAs(); touch.SetSession(session_proxy); touch.SetView(view.SMProxy)
 *     if not touch.Touch(source.SMProxy, touch.GetLikely(source.SMProxy)): print(touch.GetText())
 */
#ifndef vtkHapticTouchAs_h
#define vtkHapticTouchAs_h

#include "vtkHapticViewsModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the members

#include <string>
#include <vector>

class vtkSMProxy;
class vtkSMSourceProxy;

class VTKHAPTICVIEWS_EXPORT vtkHapticTouchAs : public vtkObject
{
public:
  static vtkHapticTouchAs* New();
  vtkTypeMacro(vtkHapticTouchAs, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The session's proxy, and the view that the source is shown in; without a view the source stays as it is shown.
  void SetSession(vtkSMProxy* session);
  void SetView(vtkSMProxy* view);
  ///@}

  /// The kind that is most likely meant for the data of a source and their representation in the view; "": none.
  std::string GetLikely(vtkSMProxy* source);

  /// Has a source touched as a kind. False if the data do not fit that kind; then nothing is changed.
  bool Touch(vtkSMProxy* source, const char* kind);

  /// One sentence: the result of the last Touch(), or the reason why it did nothing.
  std::string GetText() const { return this->Text; }

protected:
  vtkHapticTouchAs();
  ~vtkHapticTouchAs() override;

private:
  void TouchSurface();
  void TouchLines();
  void TouchField();
  void HoldTool();
  void PressTissue();
  void HoldMechanism();
  void LeaveOut();

  /// The source is of no kind any more.
  void Free();
  /// The source is held or pressed from now on. A mechanism takes the place of tool and soft body, either of these that
  /// of a mechanism.
  void Take(const char* setting);
  void Show(bool shown);
  void FollowStreamlines(const std::string& array);
  void FeelIsosurface(const std::string& array);
  std::string FieldArray() const;
  std::vector<std::string> ArraysOf(int components) const;
  /// A level as it is seen, and as it is felt.
  struct Level
  {
    double Seen, Felt;
  };
  Level LevelOf(const std::string& array) const;
  double MiddleOf(const std::string& array) const;
  double LongestSide() const;
  vtkSMProxy* Representation() const;

  vtkSmartPointer<vtkSMProxy> Session;
  vtkSmartPointer<vtkSMProxy> View;
  vtkSMSourceProxy* Source = nullptr; ///< of the Touch() that runs
  std::string Name;                   ///< of that source
  std::string Text;
};

#endif
