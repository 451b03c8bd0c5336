// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticViewScene
 * @brief   keeps the scene of a haptic session the same as the surfaces that a render view shows
 *
 * Every visible surface of the view is touched, under the name it has in the pipeline browser and with the
 * transform of its representation; 3-D glyphs as many surfaces, an image slice as curves. Volumes, views of a remote
 * server and views that are no render views are refused with a sentence. Nothing here needs Qt: the panel and Python
 * use the same class.
 *
 *     scene = servermanager.ProxyManager().NewProxy("haptics", "HapticViewScene")
 *     scene.GetProperty("View").SetProxy(0, view.SMProxy); scene.GetProperty("Session").SetProxy(0, session)
 *     scene.UpdateVTKObjects(); scene.InvokeCommand("Update")
 */
#ifndef vtkHapticViewScene_h
#define vtkHapticViewScene_h

#include "vtkHapticViewsModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation
#include <string> // for the return type

class vtkHapticSession;
class vtkSMProxy;

class VTKHAPTICVIEWS_EXPORT vtkHapticViewScene : public vtkObject
{
public:
  static vtkHapticViewScene* New();
  vtkTypeMacro(vtkHapticViewScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The proxy of the view to follow; null for none. Any view may be given: one that cannot be touched is refused in
   * the report. The proxy is watched, not kept alive; a view that is deleted leaves an empty scene at the next
   * Update().
   */
  void SetView(vtkSMProxy* view);
  vtkSMProxy* GetView() const;
  ///@}

  ///@{
  /**
   * A curve that is drawn with a widget before it is shown for the first time, felt as it is drawn; null (default) for
   * none. Watched, not kept alive. Curves that are shown need no naming: they are felt where their widgets draw them,
   * applied or not.
   */
  void SetDrawing(vtkSMProxy* source);
  vtkSMProxy* GetDrawing() const;
  ///@}

  /// Gives a session's proxy the ranges of the view's colour maps of arrays that are felt: data ranges, isovalue and
  /// levels. A line for each that was given; "" where nothing that is felt is coloured by.
  std::string TakeColorRange(vtkSMProxy* session);

  ///@{
  /// The session that is given the scenes.
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession() const;
  ///@}

  /**
   * Looks at the view and, if anything touchable changed since the last time (visibility, geometry, transform,
   * deletion; a curve that is being drawn; arrays if the session uses any, and its settings of them), hands a new scene
   * to the session. Colours and camera do not count. Costs microseconds when nothing changed. GUI thread. Returns true
   * if a scene was handed over.
   */
  bool Update();

  ///@{
  /// Whether large data are read by threads before the session gets them, so that Update() never holds its caller for
  /// longer than a picture takes and is to be called until they are; off (default): at once.
  vtkSetMacro(ReadsAhead, bool);
  vtkGetMacro(ReadsAhead, bool);
  ///@}

  /// Repeats cancelled work: the next Update() passes it on.
  void TakeAgain();

  /// Shows the held body and the soft body as the session has them now, without handing over anything else: at rest
  /// once it does not touch any more.
  void ShowHanded();

  /// Names of the touched surfaces, then one line for each thing that is not touched: reason and remedy.
  const char* GetReport() const;

  /// Why nothing that the view shows now can be touched, and the remedy; "" where something can. Looks at the view,
  /// hands nothing over.
  std::string GetRefusal() const;

  int GetNumberOfSurfaces() const;

  /// Names of all arrays of points and cells with numbers that the view shows now, a line each, sorted.
  std::string GetArrayNames() const;

  /// Names of the arrays of the sources that are shown, however they are drawn, that may be felt as a field; of so many
  /// components, 0: of any.
  std::string GetFieldNames(int components) const;

protected:
  vtkHapticViewScene();
  ~vtkHapticViewScene() override;

private:
  void HandOver();
  void WriteReport();

  bool ReadsAhead = false;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
