// A rubber strap with a waist and a hole, 160 x 50 x 16 mm (E 1e6 Pa, nu 0.45, rho 1100 kg/m3), after the strips on which
// rubber is tested. Lengths in metres; it is held at x = 0 and pulled and twisted at x = 0.16. Make the mesh again with
//   gmsh -3 -o config/strap.msh config/strap.geo
SetFactory("OpenCASCADE");
DefineConstant[ size = {0.0115, Name "Size of a cell"} ];
long = 0.16;    // along x
wide = 0.05;    // along y
thick = 0.016;  // along z
waist = 0.034;  // the width in the middle
round = 0.10;   // radius of the waist's sides
hole = 0.0085;  // radius

// Two halves along the middle plane y = 0, so that each half of the end is a set of its own.
Box(1) = {0, 0, -thick / 2, long, wide / 2, thick};
Box(2) = {0, -wide / 2, -thick / 2, long, wide / 2, thick};
Cylinder(3) = {long / 2, waist / 2 + round, -thick, 0, 0, 2 * thick, round};
Cylinder(4) = {long / 2, -waist / 2 - round, -thick, 0, 0, 2 * thick, round};
Cylinder(5) = {long / 2, 0, -thick, 0, 0, 2 * thick, hole};
cut[] = BooleanDifference{ Volume{1, 2}; Delete; }{ Volume{3, 4, 5}; Delete; };
parts[] = BooleanFragments{ Volume{cut[]}; Delete; }{};

e = 1e-5;
Physical Volume("rubber") = parts[];
Physical Surface("clamp") = Surface In BoundingBox{-e, -wide, -thick, e, wide, thick};
Physical Surface("left") = Surface In BoundingBox{long - e, -e, -thick, long + e, wide, thick};
Physical Surface("right") = Surface In BoundingBox{long - e, -wide, -thick, long + e, e, thick};

Mesh.MeshSizeMax = size;
Mesh.MeshSizeFromCurvature = 12;  // cells around a full circle
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
