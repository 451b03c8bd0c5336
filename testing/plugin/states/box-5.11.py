# state file generated using paraview version 5.11.0
import paraview
paraview.compatibility.major = 5
paraview.compatibility.minor = 11

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Render View'
renderView1 = CreateView('RenderView')
renderView1.ViewSize = [480, 527]
renderView1.AxesGrid = 'GridAxes3DActor'
renderView1.CenterOfRotation = [3.0, 0.0, 0.0]
renderView1.StereoType = 'Crystal Eyes'
renderView1.CameraPosition = [3.0, 0.0, 365.26718401841384]
renderView1.CameraFocalPoint = [3.0, 0.0, 0.0]
renderView1.CameraFocalDisk = 1.0
renderView1.CameraParallelScale = 95.0823724571665

SetActiveView(None)

# ----------------------------------------------------------------
# setup view layouts
# ----------------------------------------------------------------

# create new layout object 'Layout #1'
layout1 = CreateLayout(name='Layout #1')
layout1.AssignView(0, renderView1)
layout1.SetSize(480, 527)

# ----------------------------------------------------------------
# restore active view
SetActiveView(renderView1)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'Box'
box = Box(registrationName='Box')
box.XLength = 100.0
box.YLength = 100.0
box.ZLength = 100.0

# ----------------------------------------------------------------
# setup the visualization in view 'renderView1'
# ----------------------------------------------------------------

# show data from box
boxDisplay = Show(box, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
boxDisplay.Representation = 'Surface'
boxDisplay.ColorArrayName = [None, '']
boxDisplay.SelectTCoordArray = 'TCoords'
boxDisplay.SelectNormalArray = 'Normals'
boxDisplay.SelectTangentArray = 'None'
boxDisplay.Position = [3.0, 0.0, 0.0]
boxDisplay.OSPRayScaleArray = 'Normals'
boxDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
boxDisplay.SelectOrientationVectors = 'None'
boxDisplay.ScaleFactor = 10.0
boxDisplay.SelectScaleArray = 'None'
boxDisplay.GlyphType = 'Arrow'
boxDisplay.GlyphTableIndexArray = 'None'
boxDisplay.GaussianRadius = 0.5
boxDisplay.SetScaleArray = ['POINTS', 'Normals']
boxDisplay.ScaleTransferFunction = 'PiecewiseFunction'
boxDisplay.OpacityArray = ['POINTS', 'Normals']
boxDisplay.OpacityTransferFunction = 'PiecewiseFunction'
boxDisplay.DataAxesGrid = 'GridAxesRepresentation'
boxDisplay.PolarAxes = 'PolarAxesRepresentation'
boxDisplay.SelectInputVectors = ['POINTS', 'Normals']
boxDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
boxDisplay.ScaleTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
boxDisplay.OpacityTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
boxDisplay.PolarAxes.Translation = [3.0, 0.0, 0.0]

# ----------------------------------------------------------------
# restore active source
SetActiveSource(box)
# ----------------------------------------------------------------
# touched sources and tool, and what it feels like
haptics = servermanager.ProxyManager().GetProxy('haptics', 'HapticSession')
if haptics:
    haptics.SetPropertyWithName('SourcesText', 'Source,Touched,Stiffness,FrictionStatic,FrictionKinetic\nBox,1,250,-1,-1\n')
    haptics.SetPropertyWithName('Stiffness', 400.0)
    haptics.SetPropertyWithName('VirtualTime', 1)
