#!/bin/bash
# What accuracy costs: the error of four scenes against the processor seconds they take, over every numerical choice.
# data.csv holds a row per run; compare.py makes the table, the figure and the Pareto front.
#
#   ./Allrun            # half an hour on one core
#   ./Allrun -quick     # three minutes

. ../shared/runFunctions
. ../shared/scenes
start "$@"

# Processor seconds of the last run of a function
spent=0
measure()
{
    local TIMEFORMAT='%U'
    { time "$@" > /dev/null 2>&3; } 3>&2 2> spent
    spent=$(tail -n 1 spent)
}

# row <scene> <knob> <setting> <D/dx> <time step> <value> <cost>
row()
{
    local IFS=,
    echo "$*" | tee -a data.csv
}

# --- Drag of a cubic array of spheres, four places in the grid
# array <knob> <setting> <D/dx> [models]
array()
{
    local x y z sum=0 seconds=0 n=0
    while read -r x y z
    do
        measure arrayCase 0.125 "$3" "$x" "$y" "$z" <<< "${4:-}"
        sum="$sum + ($K/4.292 - 1)^2"; seconds="$seconds + $spent"; n=$((n + 1))
    done < <(positions 4 0.3 0.7)
    row array "$1" "$2" "$3" '' "$(calc "sqrt(($sum)/$n)")" "$(calc "($seconds)/$n")"
}

# --- Drag on the tethered cell at 980 um/s, after 0.25 s
# tether <knob> <setting> <D/dx> <time step> [lines "file entry value" or "file -remove entry"]
tether()
{
    local file entry value
    rm -rf case
    channelCase case "$3" "$4" 980 0.25
    sed -i '/writeInterval/! s/^writeControl .*/writeControl none;/' case/system/controlDict
    while read -r file entry value
    do
        case $entry in
            '') ;;
            -remove) foamDictionary -entry "$value" -remove "case/$file" > /dev/null ;;
            *) foamDictionary -entry "$entry" -set "$value" "case/$file" > /dev/null ;;
        esac
    done <<< "${5:-}"
    inCase case blockMesh
    measure solveTethered
    row tether "$1" "$2" "$3" "$4" "$(grep -h healthy case/postProcessing/clumpForce/0/clumpForce.dat |
        awk '{ t[NR] = $1; f[NR] = $4 } END { if (t[NR] < 0.2499) print "lost"; else print 1e12*f[NR] }')" \
        "$(calc "$spent/0.25")"
}

# A run may be lost: that is a result
solveTethered()
{
    (cd case && timeout 900 rbcIbFoam > log.rbcIbFoam 2>&1)
}

# The preset, and nothing else, for models, solvers and limits of the step
# preset <name> <D/dx>
preset()
{
    tether preset "$1" "$2" 1e-4 "constant/clumpProperties accuracy $1
constant/clumpProperties -remove rotation
constant/clumpProperties -remove exchange
constant/clumpProperties -remove immersedBoundary
constant/clumpProperties types/healthy/shape/nSpheres $3
system/fvSolution solvers {}
system/fvSolution PISO { pRefCell 0; pRefValue 0; }
system/controlDict adjustTimeStep yes
system/controlDict -remove maxCo"
}

# --- Rotation of the free cell in shear over 0.1 s
# shear <knob> <setting> <D/dx> <time step> [parameters]
shear()
{
    measure shearCase "$3" "$4" 0.1 "22.5e-6 11.25e-6 11.25e-6" <<< "${5:-}"
    row shear "$1" "$2" "$3" "$4" \
        "$(awk '!/^#/ { angle -= $15*($1 - t); t = $1 } END { print angle }' case/postProcessing/clumpShape/0/clumpShape.dat)" \
        "$(calc "$spent/0.1")"
}

# --- Stretching curve: deviation from the measured diameters, for N spheres with the same bonds
# stretching <N>
stretching()
{
    sed "/^variants/,/^);/d; s#reference/#../stretching/reference/#; s#\"freeParameters\"#\"../stretching/freeParameters\"#" \
        ../stretching/healthy > curve
    echo "variants ( { shape { nSpheres $1; } } );" >> curve
    measure calibrateClump -evaluate curve
    row stretching N "$1" '' '' "$(awk -F, 'NR > 1 { d = 1 - $6/$4; s += d*d; ++n } END { print sqrt(s/n) }' \
        curve.evaluated/residuals.csv)" "$spent"
}

