// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticWire
 * @brief   a wire that is pushed into the vessel of its input
 *
 * Output: as of vtkHapticMechanism, a wire in its sheath and its vessel, which a session holds and Touch Along Path
 * pushes. Input: the vessel, any data with a surface. The sheath ends at Mouth and points to Ahead. SceneFile, if it is
 * given, gets the same as a scene file (docs/mechanisms.md), with the vessel beside it as VTP. Bad input is an error of
 * one line and leaves the output empty.
 */
#ifndef vtkHapticWire_h
#define vtkHapticWire_h

#include <string>

#include "vtkHapticMechanism.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class VTKHAPTICPIPELINE_EXPORT vtkHapticWire : public vtkHapticMechanism
{
public:
  static vtkHapticWire* New();
  vtkTypeMacro(vtkHapticWire, vtkHapticMechanism);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Where the sheath ends, and a point that it points to [u].
  vtkSetVector3Macro(Mouth, double);
  vtkGetVector3Macro(Mouth, double);
  vtkSetVector3Macro(Ahead, double);
  vtkGetVector3Macro(Ahead, double);
  ///@}

  ///@{
  /// Whether the sheath ends in the middle of the vessel's section at Mouth, across its direction.
  vtkSetMacro(Centred, bool);
  vtkGetMacro(Centred, bool);
  ///@}

  ///@{
  /// Of the wire, its tip included [u].
  vtkSetMacro(Diameter, double);
  vtkGetMacro(Diameter, double);
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /// Metres of a unit of the data.
  vtkSetMacro(Unit, double);
  vtkGetMacro(Unit, double);
  ///@}

  enum Materials
  {
    NITI,
    STEEL,
    NYLON,
    OTHER
  };
  ///@{
  /// A stiffness that is assumed, or OTHER: that of Young [Pa].
  vtkSetClampMacro(Material, int, NITI, OTHER);
  vtkGetMacro(Material, int);
  vtkSetMacro(Young, double);
  vtkGetMacro(Young, double);
  ///@}

  ///@{
  vtkSetMacro(Poisson, double);
  vtkGetMacro(Poisson, double);
  ///@}

  ///@{
  /// Coulomb's, along the wire and around it together.
  vtkSetMacro(Friction, double);
  vtkGetMacro(Friction, double);
  ///@}

  enum Tips
  {
    STRAIGHT,
    ANGLED,
    HOOK,
    HELIX
  };
  ///@{
  /// Shape of the tip at rest; its length, and radius and pitch of a helix [u]. TipYoung [Pa]; 0: as the shaft.
  vtkSetClampMacro(Tip, int, STRAIGHT, HELIX);
  vtkGetMacro(Tip, int);
  vtkSetMacro(TipLength, double);
  vtkGetMacro(TipLength, double);
  vtkSetMacro(TipRadius, double);
  vtkGetMacro(TipRadius, double);
  vtkSetMacro(TipPitch, double);
  vtkGetMacro(TipPitch, double);
  vtkSetMacro(TipYoung, double);
  vtkGetMacro(TipYoung, double);
  ///@}

  ///@{
  /// How many beams the wire is made of; 0: as long as 8 diameters each, at most 64.
  vtkSetMacro(Beams, int);
  vtkGetMacro(Beams, int);
  ///@}

  ///@{
  /// Written anew whenever the wire is; "": none.
  vtkSetMacro(SceneFile, std::string);
  vtkGetMacro(SceneFile, std::string);
  ///@}

protected:
  vtkHapticWire();
  ~vtkHapticWire() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  vtkHapticMechanismResult ReadScene() override;

private:
  /// Triangles of the vessel, or why there are none.
  void TakeVessel(vtkDataObject* vessel);
  /// Mouth, or the middle of the vessel there.
  void PlaceMouth();
  /// The scene file's text; `vessel`: name of the vessel's file, "": the text is without one.
  std::string Describe(const std::string& vessel, const double mouth[3]) const;
  /// A problem, or "": both files are written.
  std::string Write() const;

  double Mouth[3] = { 0.0, 0.0, 0.0 };
  double Ahead[3] = { 1.0, 0.0, 0.0 };
  double Placed[3] = { 0.0, 0.0, 0.0 }; ///< where the sheath ends, as PlaceMouth() has put it
  bool Centred = true;
  double Diameter = 0.5, Length = 250.0, Unit = 0.001;
  int Material = NITI;
  double Young = 6e10;
  double Poisson = 0.3;
  double Friction = 0.0;
  int Tip = STRAIGHT;
  double TipLength = 0.0, TipRadius = 0.0, TipPitch = 0.0, TipYoung = 0.0;
  int Beams = 0;
  std::string SceneFile;

  std::string Made;                  ///< all properties of the last wire
  vtkSmartPointer<vtkPolyData> Wall; ///< triangles of the vessel; null: it has none
  std::string NoWall;                ///< why, then
  vtkMTimeType VesselTime = 0;
};

#endif
