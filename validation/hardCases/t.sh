#!/bin/bash
# Hard cases in one matrix: a red blood cell in a box with walls in shear, pushed in one direction at a time far past
# what a user would set. data.csv holds a row per run; compare.py the criteria, the table and the map of stability.

. ../shared/runFunctions
start "$@"

r=1.955e-6          # ring and spheres

# hard <name> <should: hold, stop or refuse> <D/dx> <time step> <steps>, parameters from standard input. From outside:
# shear [1/s], width of the box in outer diameters, control (further lines of controlDict), mesher (command after blockMesh).
shear=200
width=3
control=""
mesher=""
hard()
{
    local n box status=0
    n=$(calc "int($width*7.82e-6*$3/(2*$r) + 0.5)")
    box=$(calc "$n*2*$r/$3")
    boxCase case <<PARAMETERS
lx $box; ly $box; lz $box; nx $n; ny $n; nz $n;
yType wall; yU fixedValue; yP zeroGradient;
y0 ($(calc "-0.5*$shear*$box") 0 0); y1 ($(calc "0.5*$shear*$box") 0 0);
nu 1.2e-6; rho 1000; deltaT $4; endTime $(calc "$5*$4");
$(cat ../../tutorials/resources/cells/healthy | sed '/^shape/,/^}/d')
#remove bondModel
$(sed -n '/^bondModel/,/^}/p' ../../tutorials/resources/cells/healthy)
shape { type ring; nSpheres 10; ringRadius $r; sphereRadius $r; }
middle ($(calc "0.5*$box") $(calc "0.5*$box") $(calc "0.5*$box"));
box $box;
places { type list; clumps ( { type body; position \$middle; } ); }
$(cat)
PARAMETERS
    [ "$5" -gt 5000 ] && sed -i "s/writeInterval   1;/writeInterval $(($5/10));/" case/system/controlDict
    echo "$control" >> case/system/controlDict
    inCase case blockMesh
    [ -z "$mesher" ] || inCase case $mesher
    if [ "$ranks" -gt 1 ]
    then
        inCase case decomposePar -force
        (cd case && timeout 600 mpirun --oversubscribe -np "$ranks" rbcIbFoam -parallel < /dev/null) \
            > case/log.rbcIbFoam 2>&1 || status=$?
    else
        (cd case && timeout 600 rbcIbFoam) > case/log.rbcIbFoam 2>&1 || status=$?
    fi

    # Longest diameter ever and at the end, clumps at the end, over all rows
    local shape=case/postProcessing/clumpShape/0/clumpShape.dat
    echo "$1,$2,$3,$4,$5,$shear,$(sed -n 's/^Placed \([0-9]*\) clumps/\1/p' case/log.rbcIbFoam),$status,$(awk '
        /^#/ { next }
        /nan|inf/ { bad = 1 }
        $1 != t { t = $1; n = 0; last = 0 }
        { ++n; for (i = 7; i <= 9; ++i) { if ($i > most) most = $i; if ($i > last) last = $i } }
        END { printf "%d,%g,%g,%d", n, most, last, bad }' "$shape" 2>/dev/null || echo 0,0,0,0),$(awk '
        /^Continuity error/ { c = $4 + 0 } END { printf "%g", c }' case/log.rbcIbFoam),$(
        seconds case)" | tee -a data.csv
}

box=23.46e-6    # at D/dx = 4
at()
{
    calc "$box*($1)"; echo -n " "; calc "$box*($2)"; echo -n " "; calc "$box*($3)"
}

# A force [N] pulling (or pushing, below zero) at opposite spheres until half of the time
load()
{
    echo "loads { pull { type oppositeForces; clumpType body; direction (1 0 0); plus (0); minus (5);
        force table ((0 $1) ($2 $1) ($(calc "1.0001*$2") 0) (1e3 0)); } }"
}

echo "name,should,D_dx,deltaT_s,steps,shear_rate,placed,status,clumps,longest_m,last_m,nan,continuity,seconds" > data.csv

steps=20
width=1.5
false && hard "D/dx 16" hold 16 1e-3 $steps < /dev/null
width=3
hard "dt 1e-8" hold 4 1e-8 $steps < /dev/null

# The step ten times as long from one step to the next, and back; and as long as its limits allow
jumps="((0 1e-4) (1e-3 1e-4) (1.00001e-3 1e-3) (11e-3 1e-3) (11.0001e-3 1e-5) (1 1e-5))"
control="adjustTimeStep yes;
functions { jump { type setTimeStep; libs (\"libutilityFunctionObjects.so\"); deltaT table $jumps; } }"
hard "steps of 1e-4 then 1e-3 then 1e-5 s" hold 4 1e-4 115 < /dev/null
control="adjustTimeStep yes; maxCo 0.5; maxDisplacement 0.1; maxDeltaT 1e-3;"
hard "adjustable step from 1e-6 s" hold 4 1e-6 5000 < /dev/null
control=""

# Meshes
dt=1e-4
hard "graded 1:10 in every direction" hold 6 $dt $steps <<< "grading (10 10 0.1);"
mesher="polyDualMesh 30 -overwrite -concaveMultiCells"
hard "polyhedral mesh" hold 6 $dt $steps <<PARAMETERS
correction corrected;
xType wall; xU fixedValue; xP zeroGradient; zType wall; zU fixedValue; zP zeroGradient;
PARAMETERS
mesher=""

# A clump larger than the part of a processor, in the corner of the periodic box
serial=$ranks
for ranks in $($quick && echo 2 || echo 1 8)
do
    hard "$ranks ranks and a cell in the corner" hold 4 $dt $steps <<PARAMETERS
places { type list; clumps ( { type body; position ($(at 0.001 0.7 0.999)); } ); }
PARAMETERS
done
ranks=$serial

shear=1000
$quick || hard "32 cells at 1000 1/s" hold 4 $dt 5 <<PARAMETERS
lx 45e-6; ly 22.5e-6; lz 22.5e-6; nx 46; ny 23; nz 23;
y0 (-11.25e-3 0 0); y1 (11.25e-3 0 0);
contact { type hertz; reducedModulus 100; restitution 0.5; }
places { type lattice; clumpType body; origin (5.6e-6 5.6e-6 2.8e-6); spacing (11.25e-6 11.3e-6 5.625e-6); number (4 2 4); }
PARAMETERS
