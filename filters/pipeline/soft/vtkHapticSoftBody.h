// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkHapticSoftBody
 * @brief   tetrahedra that deform under a hand
 *
 * Port 0: the body. Cells that fill space as they are, cut into tetrahedra where they are none; a closed surface (poly
 * data), filled by CGAL's Mesh_3; or a label image (image data with the active point scalars), each of whose labels but
 * 0 is filled. Port 1, optional: its support: each vertex is fixed that is within FixedDistance of its cells, or of its
 * points where it has no cells, as an extracted selection, a plane or a bone. Output: the tetrahedra with
 *
 *     Fixed         (n)    int     1: fixed
 *     Displacement  (n, 3) double  of the finite elements' nodes, 0: at rest [u]
 *     Dent          (n, 3) double  how much further a point is shown, where something presses [u]
 *     Young         (m)    double  of the cells [Pa]
 *     Strain        (m, 6) double  Green's, 0: at rest; xx yy zz xy yz xz
 *     Stress        (m, 6) double  Cauchy's, likewise [Pa]
 *     Label         (m)    int     of a label image: which one
 *     Load          (n, 3) double  that it bears always [N], where it bears anything
 *
 * and with its material as field data: the input of a session and of Touch Along Path. On several ranks the first has
 * the body that the pieces of all are. Bad input is an error of one line and leaves the output empty.
 */
#ifndef vtkHapticSoftBody_h
#define vtkHapticSoftBody_h

#include "vtkHapticPipelineModule.h" // for the export macro
#include "vtkSmartPointer.h"         // for members
#include "vtkUnstructuredGrid.h"     // for members
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // for the return type

class vtkDataSet;

class VTKHAPTICPIPELINE_EXPORT vtkHapticSoftBody : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHapticSoftBody* New();
  vtkTypeMacro(vtkHapticSoftBody, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Young's modulus [Pa], from 10 to below 1e12. Default 20000, assumed: about that of liver.
  vtkSetMacro(Young, double);
  vtkGetMacro(Young, double);
  ///@}

  ///@{
  /// Array of the tetrahedra with their modulus [Pa]. Default none: Young.
  vtkSetStringMacro(YoungArray);
  vtkGetStringMacro(YoungArray);
  ///@}

  ///@{
  /// Poisson's ratio, 0 to below .5. Default .4, assumed; above it tetrahedra get nodes halfway their edges.
  vtkSetMacro(Poisson, double);
  vtkGetMacro(Poisson, double);
  ///@}

  enum ModelChoices
  {
    Linear,
    CoRotational,
    NeoHookean
  };

  ///@{
  /// Hooke's law of small strains, the same in the turned frame, or stable neo-Hookean. Default NeoHookean.
  vtkSetClampMacro(Model, int, Linear, NeoHookean);
  vtkGetMacro(Model, int);
  ///@}

  ///@{
  /// Metres a unit of the data, > 0. Default 1, assumed.
  vtkSetMacro(Unit, double);
  vtkGetMacro(Unit, double);
  ///@}

  ///@{
  /// Fixed vertices: sides of the body's bounding box (xmin, xmax, ymin, ymax, zmin, zmax, separated by commas), or a
  /// point array, where it is not 0. Default none.
  vtkSetStringMacro(Fixed);
  vtkGetStringMacro(Fixed);
  ///@}

  ///@{
  /// Its density [kg/m3], above 0. Default 1000, assumed: as water. Of its weight, and of how fast it can follow.
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /// By which it bears its weight always [m/s2]. Default 0: it bears none.
  vtkSetVector3Macro(Gravity, double);
  vtkGetVector3Macro(Gravity, double);
  ///@}

  ///@{
  /// Point array with a permanent force on each vertex, three components [N]. Default none.
  vtkSetStringMacro(LoadArray);
  vtkGetStringMacro(LoadArray);
  ///@}

  ///@{
  /// How near port 1 holds a vertex [u], >= 0. Default 0: a thousandth of the body's diagonal.
  vtkSetMacro(FixedDistance, double);
  vtkGetMacro(FixedDistance, double);
  ///@}

  ///@{
  /// Longest edges of tetrahedra that are made [u], >= 0. Default 0: a twelfth of the diagonal.
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

  ///@{
  /// Largest distance from the filled surface [u], >= 0. Default 0: a quarter of an edge.
  vtkSetMacro(SurfaceDistance, double);
  vtkGetMacro(SurfaceDistance, double);
  ///@}

  /// Has the output show a state of the body until it is made anew; null: at rest.
  void ShowBent(vtkUnstructuredGrid* bent);
  /// The body at rest; null before it has been made. Another object each time it is made anew.
  vtkUnstructuredGrid* GetRest() const { return this->Rest; }

  /// Summary of the model, with "assumed" at default values; empty before it has run.
  const char* GetText() const { return this->Text.c_str(); }

protected:
  vtkHapticSoftBody();
  ~vtkHapticSoftBody() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** input, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /// The tetrahedra of a body, meshed where they are not given, and how far their border may be off; null with a
  /// problem.
  vtkSmartPointer<vtkUnstructuredGrid> Mesh(vtkDataObject* data, double& rough, std::string& problem);
  bool Make(vtkDataObject* data, vtkDataSet* holds, vtkUnstructuredGrid* output, std::string& problem);
  bool Goes(double progress);
  /// Whether only the deformation has changed since Rest was made.
  bool OnlyBends(vtkMTimeType inputs);

  double Young;
  char* YoungArray = nullptr;
  double Poisson;
  int Model = NeoHookean;
  double Unit = 1.0;
  char* Fixed = nullptr;
  double Density;
  double Gravity[3] = { 0.0, 0.0, 0.0 };
  char* LoadArray = nullptr;
  double FixedDistance = 0.0;
  double EdgeLength = 0.0;
  double SurfaceDistance = 0.0;
  std::string Text;
  vtkSmartPointer<vtkUnstructuredGrid> Rest;
  vtkSmartPointer<vtkUnstructuredGrid> Bent;
  vtkMTimeType KnownTime = 0;  ///< of the settings of Rest, and of the deformations since
  vtkMTimeType InputsTime = 0; ///< of the input of Rest
};

#endif
