// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticInteractor
 * @brief   touch and see in any VTK program: a renderer and actors in, a session and tool props inside
 *
 *     touch = vtkHapticInteractor()
 *     touch.SetRenderer(renderer)
 *     touch.AddActor(actor)
 *     touch.Start()
 *     touch.GetSession().SetHandPosition(0, 0, 0.4)
 *     touch.Update()
 *     window.Render()
 *
 * Update(), once a frame, follows the actors: their matrices, the data of their mappers, their visibility. One thread
 * calls every method.
 */
#ifndef vtkHapticInteractor_h
#define vtkHapticInteractor_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation

class vtkActor;
class vtkHapticMouse;
class vtkHapticSession;
class vtkHapticToolProps;
class vtkRenderWindowInteractor;
class vtkRenderer;

class VTKHAPTICINTERACTION_EXPORT vtkHapticInteractor : public vtkObject
{
public:
  static vtkHapticInteractor* New();
  vtkTypeMacro(vtkHapticInteractor, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the tool is drawn; null for nowhere.
  void SetRenderer(vtkRenderer* renderer);

  ///@{
  /// Touched props: actors whose mapper has polygons. Kept alive until they are removed.
  void AddActor(vtkActor* actor);
  void RemoveActor(vtkActor* actor);
  void RemoveAllActors();
  int GetNumberOfActors() const;
  ///@}

  ///@{
  /// Settings and state; how the tool is drawn.
  vtkHapticSession* GetSession() const;
  vtkHapticToolProps* GetToolProps() const;
  ///@}

  /**
   * Mouse and keyboard of this window move the hand while the session's device is "mouse" (vtkHapticMouseInput); null:
   * they do not. The interactor is watched, not kept alive.
   */
  void FollowMouse(vtkRenderWindowInteractor* interactor);
  vtkHapticMouse* GetMouse() const;

  ///@{
  /// Builds the scene, then lets the session touch; false, with the session's GetProblem(), if it cannot. And back.
  bool Start();
  void Stop();
  ///@}

  /// Hands changed surfaces to the session, takes its latest state and moves the tool.
  void Update();

protected:
  vtkHapticInteractor();
  ~vtkHapticInteractor() override;

private:
  /// True if the actors show something else than at the last call; then it is on its way to the session.
  bool HandOver();
  void FollowCamera();

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
