// A steel tuning fork whose opposing prongs swing in the plane x-y at A4 = 440 Hz (E 2.06e11 Pa, nu 0.29,
// rho 7850 kg/m3). Lengths in metres; the stem points along -y, the prongs along +y. Make the mesh again with
//   gmsh -3 -o config/fork.msh config/fork.geo
SetFactory("OpenCASCADE");
DefineConstant[
  prong = {0.08724, Name "Length of the straight prongs"}
  size = {0.0025, Name "Size of a cell"}
];
width = 0.005;   // of a prong, in the plane of motion
depth = 0.007;   // of prongs and yoke, across it
inner = 0.004;   // radius of the yoke's inside: half the gap between the prongs
outer = inner + width;
stem = 0.00275;  // radius
stem_end = -0.050;

// The prongs and the yoke: a U, extruded across the plane.
Point(1) = {0, 0, -depth / 2};
Point(2) = {-inner, 0, -depth / 2};
Point(3) = {inner, 0, -depth / 2};
Point(4) = {-outer, 0, -depth / 2};
Point(5) = {outer, 0, -depth / 2};
Point(6) = {-inner, prong, -depth / 2};
Point(7) = {inner, prong, -depth / 2};
Point(8) = {-outer, prong, -depth / 2};
Point(9) = {outer, prong, -depth / 2};
Point(10) = {0, -inner, -depth / 2};
Point(11) = {0, -outer, -depth / 2};
Line(1) = {8, 4};
Circle(2) = {4, 1, 11};
Circle(3) = {11, 1, 5};
Line(4) = {5, 9};
Line(5) = {9, 7};
Line(6) = {7, 3};
Circle(7) = {3, 1, 10};
Circle(8) = {10, 1, 2};
Line(9) = {2, 6};
Line(10) = {6, 8};
Curve Loop(1) = {1 ... 10};
Plane Surface(1) = {1};
u[] = Extrude {0, 0, depth} { Surface{1}; };

// The stem: a rod with a round end, turned about the axis y; its top lies inside the yoke.
Point(101) = {0, -(inner + outer) / 2, 0};
Point(102) = {stem, -(inner + outer) / 2, 0};
Point(103) = {stem, stem_end + stem, 0};
Point(104) = {0, stem_end + stem, 0};
Point(105) = {0, stem_end, 0};
Line(101) = {101, 102};
Line(102) = {102, 103};
Circle(103) = {103, 104, 105};
Line(104) = {105, 101};
Curve Loop(101) = {101, 102, 103, 104};
Plane Surface(101) = {101};
s[] = Extrude {{0, 1, 0}, {0, 0, 0}, 2 * Pi} { Surface{101}; };
fork[] = BooleanUnion{ Volume{u[1]}; Delete; }{ Volume{s[1]}; Delete; };

e = 1e-5;
Physical Volume("steel") = fork[];
Physical Surface("tip_left") = Surface In BoundingBox{-outer - e, prong - e, -depth, -inner + e, prong + e, depth};
Physical Surface("tip_right") = Surface In BoundingBox{inner - e, prong - e, -depth, outer + e, prong + e, depth};
Physical Surface("stem_end") = Surface In BoundingBox{-stem - e, stem_end - e, -stem - e, stem + e, stem_end + stem + e, stem + e};

Mesh.MeshSizeMax = size;
Mesh.MeshSizeFromCurvature = 10;  // cells around a full circle
Mesh.ElementOrder = 2;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
