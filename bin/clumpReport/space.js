// The view in space, by three.js: clumps, walls, the slice of the flow, and the time.
const DIRECTION = [-0.397, 0.342, 0.852];       // to the eye, as in the still picture
const GREY = 0x888888;

function decoded(text, Kind) {
    return new Kind(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);
}

function surface(points, triangles, material) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(decoded(points, Float32Array), 3));
    geometry.setIndex(new THREE.BufferAttribute(decoded(triangles, Uint32Array), 1));
    geometry.computeVertexNormals();
    return new THREE.Mesh(geometry, material);
}

// Spheres of one type: x, y, z and radius of each
function ballsOf(values, material) {
    const count = values.length/4, matrix = new THREE.Matrix4();
    const ball = new THREE.SphereBufferGeometry(1, 20, 14);
    const balls = new THREE.InstancedMesh(ball, material, count);
    for (let k = 0; k < count; ++k) {
        const [x, y, z, r] = values.subarray(4*k, 4*k + 4);
        balls.setMatrixAt(k, matrix.makeScale(r, r, r).setPosition(x, y, z));
    }
    balls.frustumCulled = false;
    return balls;
}

function label(text, place, height) {
    const canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
    [canvas.width, canvas.height] = [256, 64];
    pen.font = "40px sans-serif";
    pen.fillStyle = "#888";
    pen.textAlign = "center";
    pen.fillText(text, 128, 46);
    const map = new THREE.CanvasTexture(canvas);
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map, depthTest: false }));
    sprite.scale.set(4*height, height, 1);
    sprite.position.copy(place);
    sprite.renderOrder = 1;         // after the walls
    return sprite;
}

// The edges of the domain with their lengths
function frame(box, unit) {
    const group = new THREE.Group().add(new THREE.Box3Helper(box, GREY));
    const size = box.getSize(new THREE.Vector3()), span = size.length();
    ["x", "y", "z"].forEach(axis => {
        const place = box.min.clone();      // below the front and the left edge, and at the right
        place.y -= 0.04*span;
        if (axis !== "z") place.z = box.max.z;
        if (axis === "y") place.x = box.max.x + 0.08*span;
        place[axis] = (box.min[axis] + box.max[axis])/2;
        group.add(label(`${axis} ${Number(size[axis].toPrecision(3))} ${unit}`, place, 0.05*span));
    });
    return group;
}

// A distance from which all corners of the box are seen
function distance(camera, box, direction) {
    camera.position.copy(direction);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const half = Math.tan(camera.fov*Math.PI/360), centre = box.getCenter(new THREE.Vector3());
    const turned = camera.quaternion.clone().conjugate();
    return Math.max(...[0, 1, 2, 3, 4, 5, 6, 7].map(n => {
        const ends = ["x", "y", "z"].map((a, k) => (n >> k & 1 ? box.max : box.min)[a]);
        const c = new THREE.Vector3(...ends).sub(centre).applyQuaternion(turned);
        return c.z + 1.05*Math.max(Math.abs(c.y), Math.abs(c.x)/camera.aspect)/half;
    }));
}

function view(element) {
    const data = JSON.parse(element.querySelector("script").textContent);
    const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true,
        preserveDrawingBuffer: true });
    const scene = new THREE.Scene(), camera = new THREE.PerspectiveCamera(30, 16/9);
    const box = new THREE.Box3(new THREE.Vector3(...data.low), new THREE.Vector3(...data.high));
    const span = box.getSize(new THREE.Vector3()).length();
    const lamp = new THREE.DirectionalLight(0xffffff, 0.75);
    lamp.position.set(-0.45, 0.6, 0.66);
    camera.add(lamp);
    scene.add(camera, new THREE.AmbientLight(0xffffff, 0.45), frame(box, data.unit));

    const walls = new THREE.Group(), flow = new THREE.Group();
    const glass = new THREE.MeshLambertMaterial({ color: 0x8fa3bf, transparent: true, opacity: 0.18,
        side: THREE.DoubleSide, depthWrite: false });
    data.walls.forEach(w => walls.add(surface(w.points, w.triangles, glass)));
    (data.flow.parts || []).forEach(part => {
        const mesh = surface(part.points, part.triangles, new THREE.MeshBasicMaterial({
            vertexColors: THREE.VertexColors, side: THREE.DoubleSide }));
        mesh.geometry.setAttribute("color",
            new THREE.BufferAttribute(decoded(part.colours, Float32Array), 3));
        flow.add(mesh);
    });
    scene.add(walls, flow);

    const materials = colours.map((_, k) => new THREE.MeshPhongMaterial({ color: colourOf(k),
        shininess: 40, specular: 0x333333, side: THREE.DoubleSide }));
    const frames = data.frames.map(() => null);     // made when they are first shown
    let clumps = null;
    function show(k) {
        frames[k] = frames[k] || Object.entries(data.frames[k]).reduce((group, [kind, part]) => {
            const spheres = decoded(part.spheres, Float32Array);
            if (spheres.length) group.add(ballsOf(spheres, materials[kind]));
            if (part.nodes) group.add(surface(part.nodes, data.meshes[part.mesh], materials[kind]));
            return group;
        }, new THREE.Group());
        scene.remove(clumps);
        scene.add(clumps = frames[k]);
        flow.children.forEach((mesh, n) => {
            mesh.visible = n === Math.min(Math.round(k/data.flow.step), flow.children.length - 1);
        });
        element.querySelector("output").textContent = data.times[k];
        render();
    }
    const render = () => renderer.render(scene, camera);

    const controls = new THREE.OrbitControls(camera, renderer.domElement);
    const direction = new THREE.Vector3(...DIRECTION);
    function fit() {
        const width = element.clientWidth, height = Math.min(Math.max(0.62*width, 240), 560);
        renderer.setPixelRatio(window.devicePixelRatio);
        renderer.setSize(width, height, false);
        renderer.domElement.style.height = height + "px";
        camera.aspect = width/height;
        camera.near = span/100;
        camera.far = span*20;
        camera.updateProjectionMatrix();
    }
    fit();
    const away = distance(camera, box, direction);
    box.getCenter(controls.target);
    camera.position.copy(controls.target).addScaledVector(direction, away);
    controls.update();
    controls.addEventListener("change", render);
    window.addEventListener("resize", () => { fit(); render(); });
    document.addEventListener("colours", () => {
        materials.forEach((material, k) => material.color.set(colourOf(k)));
        render();
    });

    const time = element.querySelector("input[type=range]"), play = element.querySelector("button");
    let timer = 0;
    time.addEventListener("input", () => show(Number(time.value)));
    play.addEventListener("click", () => {
        clearInterval(timer);
        timer = timer ? 0 : setInterval(() => {
            time.value = (Number(time.value) + 1) % data.frames.length;
            show(Number(time.value));
        }, 150);
        play.textContent = timer ? "stop" : "play";
    });
    for (const [name, group] of [["walls", walls], ["flow", flow]]) {
        const box = element.querySelector(`input[name=${name}]`);
        if (box) box.addEventListener("change", () => { group.visible = box.checked; render(); });
        group.visible = Boolean(box && box.checked);
    }
    element.querySelector("img").replaceWith(renderer.domElement);
    show(Number(time.value));
    element.dataset.drawn = data.frames.length;
}

// The still picture stays where the browser has no WebGL
document.querySelectorAll(".space").forEach(element => {
    try { view(element); } catch (error) { element.dataset.failed = error; }
});
