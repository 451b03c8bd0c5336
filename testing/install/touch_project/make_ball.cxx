// SPDX-License-Identifier: GPL-3.0-or-later
// make_ball FILE.vtp MOVED: a ball of 50 mm whose centre has moved along x [mm]; prints the force on a hand 2 mm in it [N].

#include <cstdio>
#include <cstdlib>

#include "vtkDataArray.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTouchAlongPath.h"
#include "vtkXMLPolyDataWriter.h"

int main(int, char** words)
{
  const double moved_mm = std::atof(words[2]);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(50.0);
  ball->SetCenter(moved_mm, 0.0, 0.0);
  ball->SetThetaResolution(60);
  ball->SetPhiResolution(61);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(ball->GetOutputPort());
  writer->SetFileName(words[1]);

  vtkNew<vtkLineSource> way;
  way->SetPoint1(60.0 + moved_mm, 0.0, 0.0);
  way->SetPoint2(48.0 + moved_mm, 0.0, 0.0);
  vtkNew<vtkTouchAlongPath> touch;
  touch->SetInputConnection(0, ball->GetOutputPort());
  touch->SetInputConnection(1, way->GetOutputPort());
  touch->SetSetting("Stiffness", 500.0);
  touch->SetSetting("Scale", 1000.0);
  touch->Update();
  vtkDataArray* force = touch->GetOutput()->GetPointData()->GetArray("Force");
  std::printf("%.17g\n", force->GetComponent(force->GetNumberOfTuples() - 1, 0));
  return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
