. ./f.sh
tether D/dx 2.75 2.75 2e-3
tether D/dx 3 3 1e-3
tether D/dx 3 3 4e-3
tether D/dx 4 4 1e-3
tether D/dx 4 4 8e-3
tether N 8 4 2e-3 "constant/clumpProperties types/healthy/shape/nSpheres 8"
preset draft 3 8
grep deltaT case/log.rbcIbFoam | tail -n 1;  grep Courant case/log.rbcIbFoam | tail -n 1
preset draft 3 10
