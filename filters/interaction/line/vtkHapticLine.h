// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticLine
 * @brief   a value along a path, with detents, friction and stops, felt by turning a wheel
 *
 *     line = vtkHapticLine()
 *     line.SetPath(polyline, "temperature", 1000.0)  # 1000 scene units are a metre of the hand
 *     line.SetDeviceName("pid-1209-ffb0-17")
 *     if line.Start():
 *         line.Engage()
 *
 * The value is a hill that draws downhill. Of the device x is turned, whatever it calls itself. One thread calls every
 * method. Refusals are errors of VTK and stay in GetProblem().
 */
#ifndef vtkHapticLine_h
#define vtkHapticLine_h

#include "vtkHapticInteractionModule.h" // for the export macro
#include "vtkObject.h"

#include <memory> // for the implementation
#include <string> // for the device's name

class vtkPolyData;

class VTKHAPTICINTERACTION_EXPORT vtkHapticLine : public vtkObject
{
public:
  static vtkHapticLine* New();
  vtkTypeMacro(vtkHapticLine, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Places of the line [m of the hand], in ascending order, with a value of any unit and friction [N].
  void AddPlace(double s, double value, double friction = 0.0);
  void ClearPlaces();
  int GetNumberOfPlaces() const;
  ///@}

  /**
   * The places of a path's first line: the arc length along it, from its middle, and the value of an array of its
   * points. `scale`: scene units that are a metre of the hand, > 0. False, with GetProblem(), without such a line or
   * array.
   */
  bool SetPath(vtkPolyData* path, const char* array, double scale);

  ///@{
  /// Force at the steepest slope of the value [N]; 0.3.
  vtkSetClampMacro(HardestForce, double, 0.0, 100.0);
  vtkGetMacro(HardestForce, double);
  ///@}

  ///@{
  /// From one detent to the next [m], 0: none, and the largest force of one [N].
  vtkSetClampMacro(DetentEvery, double, 0.0, 1000.0);
  vtkGetMacro(DetentEvery, double);
  vtkSetClampMacro(DetentForce, double, 0.0, 100.0);
  vtkGetMacro(DetentForce, double);
  ///@}

  ///@{
  /// Of the springs at both ends [N/m]; 100.
  vtkSetClampMacro(StopStiffness, double, 1.0, 100000.0);
  vtkGetMacro(StopStiffness, double);
  ///@}

  ///@{
  /// The device; "simulated-joystick". In virtual time Step() computes ticks of 1 ms, and nothing runs by itself.
  void SetDeviceName(const char* name);
  const char* GetDeviceName() const;
  vtkSetMacro(VirtualTime, bool);
  vtkGetMacro(VirtualTime, bool);
  vtkBooleanMacro(VirtualTime, bool);
  /// Where the hand of a simulated device is led [m].
  vtkSetMacro(HandPosition, double);
  vtkGetMacro(HandPosition, double);
  ///@}

  /// The force of the line at a place, without friction [N]; not a number where the line is refused.
  double GetForceAt(double s);

  ///@{
  /// False, with GetProblem(), if it cannot begin. Nothing pushes before Engage(), and after a fault not before the
  /// next.
  bool Start();
  void Engage();
  void Step(int ticks);
  void Stop();
  bool GetRunning() const;
  double GetPosition();
  double GetForce();
  const char* GetProblem() const;
  ///@}

protected:
  vtkHapticLine();
  ~vtkHapticLine() override;

private:
  class Internals;
  bool Refuse(const std::string& problem);

  double HardestForce = 0.3;
  double DetentEvery = 0.0;
  double DetentForce = 0.0;
  double StopStiffness = 100.0;
  double HandPosition = 0.0;
  bool VirtualTime = false;
  std::unique_ptr<Internals> Impl;
};

#endif
