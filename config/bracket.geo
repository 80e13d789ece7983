// A steel bracket: an angle, 80 mm wide, whose upright is bolted to a wall through two holes and whose flange carries a
// lug with an eye, off its middle (E 2.06e11 Pa, nu 0.29, rho 7850 kg/m3). Lengths in metres. Make the mesh with
//   gmsh -3 -o bracket.msh config/bracket.geo
SetFactory("OpenCASCADE");
DefineConstant[ size = {0.006, Name "Size of a cell"} ];
wide = 0.08;    // along y
long = 0.10;    // of the flange, along x
high = 0.08;    // of the upright, along z
thick = 0.008;

Box(1) = {0, 0, 0, thick, wide, high};
Box(2) = {0, 0, 0, long, wide, thick};
// A rib between them.
Point(101) = {thick, wide / 2 - thick / 2, thick};
Point(102) = {thick + 0.045, wide / 2 - thick / 2, thick};
Point(103) = {thick, wide / 2 - thick / 2, thick + 0.045};
Line(101) = {101, 102};
Line(102) = {102, 103};
Line(103) = {103, 101};
Curve Loop(101) = {101, 102, 103};
Plane Surface(101) = {101};
rib[] = Extrude {0, thick, 0} { Surface{101}; };
// The lug: a plate across the flange's end, round at its top, with an eye.
lug_x = long - 0.02; lug_y = wide - 0.018; lug_z = thick + 0.022; radius = 0.011;
Box(4) = {lug_x - radius, lug_y, 0, 2 * radius, thick, lug_z};
Cylinder(5) = {lug_x, lug_y, lug_z, 0, thick, 0, radius};
body[] = BooleanUnion{ Volume{1}; Delete; }{ Volume{2, rib[1], 4, 5}; Delete; };
Cylinder(6) = {lug_x, lug_y - thick, lug_z, 0, 3 * thick, 0, 0.005};
Cylinder(7) = {-thick, 0.018, high - 0.018, 3 * thick, 0, 0, 0.0045};
Cylinder(8) = {-thick, wide - 0.018, high - 0.018, 3 * thick, 0, 0, 0.0045};
part[] = BooleanDifference{ Volume{body[]}; Delete; }{ Volume{6, 7, 8}; Delete; };

e = 1e-5;
Physical Volume("steel") = part[];
Physical Surface("bolts") = {
  Surface In BoundingBox{-e, 0.0135 - e, high - 0.0225 - e, thick + e, 0.0225 + e, high - 0.0135 + e},
  Surface In BoundingBox{-e, wide - 0.0225 - e, high - 0.0225 - e, thick + e, wide - 0.0135 + e, high - 0.0135 + e}};
Physical Surface("lug") = Surface In BoundingBox{lug_x - 0.005 - e, lug_y - e, lug_z - 0.005 - e, lug_x + 0.005 + e, lug_y + thick + e, lug_z + 0.005 + e};
Physical Surface("flange") = Surface In BoundingBox{long - e, -e, -e, long + e, wide + e, thick + e};

Mesh.MeshSizeMax = size;
Mesh.MeshSizeFromCurvature = 12;  // cells around a full circle
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
