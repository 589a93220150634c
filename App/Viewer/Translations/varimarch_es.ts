<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
<context>
    <name>ArchiveList</name>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>Password of %1 for %2. It is not kept.</source>
        <translation>Contraseña de %1 para %2. No se guarda.</translation>
    </message>
</context>
<context>
    <name>BrightnessTool</name>
    <message>
        <source>window and level</source>
        <translation>ventana y nivel</translation>
    </message>
</context>
<context>
    <name>CutHandles</name>
    <message>
        <source>push a plane</source>
        <translation>desplazar un plano</translation>
    </message>
    <message>
        <source>rotate a plane</source>
        <translation>girar un plano</translation>
    </message>
    <message>
        <source>crop</source>
        <translation>recortar</translation>
    </message>
    <message>
        <source>move the box</source>
        <translation>mover la caja</translation>
    </message>
</context>
<context>
    <name>KeyImageTexts</name>
    <message>
        <source>Axial slice</source>
        <translation>Corte axial</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Corte coronal</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Corte sagital</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>the chosen tool; at first it rotates</source>
        <translation>la herramienta elegida; al principio gira</translation>
    </message>
    <message>
        <source>Drag with Ctrl</source>
        <translation>Arrastrar con Ctrl</translation>
    </message>
    <message>
        <source>window and level</source>
        <translation>ventana y nivel</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Botón central</translation>
    </message>
    <message>
        <source>move the volume</source>
        <translation>mover el volumen</translation>
    </message>
    <message>
        <source>Wheel, right button</source>
        <translation>Rueda, botón derecho</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>ampliar o reducir</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>see this view alone, or all again</source>
        <translation>ver solo esta vista, o de nuevo todas</translation>
    </message>
    <message>
        <source>revert a gesture that is not finished</source>
        <translation>deshacer un gesto sin terminar</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>move the crosshair, or the chosen measurement</source>
        <translation>mover la cruz, o la medida elegida</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>Botón derecho</translation>
    </message>
    <message>
        <source>move the slice</source>
        <translation>mover el corte</translation>
    </message>
    <message>
        <source>Wheel, arrow and page keys</source>
        <translation>Rueda, flechas y teclas de página</translation>
    </message>
    <message>
        <source>the next slices</source>
        <translation>los cortes siguientes</translation>
    </message>
    <message>
        <source>Ctrl with wheel, + and -</source>
        <translation>Ctrl con rueda, + y -</translation>
    </message>
    <message>
        <source>zoom; Home shows the whole slice</source>
        <translation>ampliar o reducir; Inicio muestra el corte entero</translation>
    </message>
    <message>
        <source>a usual window for CT; 0 is that of the file</source>
        <translation>una ventana usual de TC; 0 es la del archivo</translation>
    </message>
    <message>
        <source>Curve of the look</source>
        <translation>Curva del aspecto</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Arrastrar un punto</translation>
    </message>
    <message>
        <source>change its value and opacity</source>
        <translation>cambiar su valor y opacidad</translation>
    </message>
    <message>
        <source>Click the curve</source>
        <translation>Clic en la curva</translation>
    </message>
    <message>
        <source>add a point</source>
        <translation>añadir un punto</translation>
    </message>
    <message>
        <source>Double-click a point</source>
        <translation>Doble clic en un punto</translation>
    </message>
    <message>
        <source>type its numbers</source>
        <translation>escribir sus números</translation>
    </message>
    <message>
        <source>choose its colour</source>
        <translation>elegir su color</translation>
    </message>
    <message>
        <source>Menus</source>
        <translation>Menús</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>Ratón y teclas</translation>
    </message>
    <message>
        <source>walk, with the tool Walk; arrow and page keys too</source>
        <translation>caminar, con la herramienta Caminar; también flechas y teclas de página</translation>
    </message>
    <message>
        <source>Drag a line of the crosshair</source>
        <translation>Arrastrar una línea de la cruz</translation>
    </message>
    <message>
        <source>turn the other slices</source>
        <translation>girar los otros cortes</translation>
    </message>
</context>
<context>
    <name>MeasureReport</name>
    <message>
        <source>A box lies along the axes of the first scan, and this one has others. Remove the boxes, or save a table.</source>
        <translation>Una caja está alineada con los ejes del primer estudio, y este tiene otros. Quite las cajas o guarde una tabla.</translation>
    </message>
</context>
<context>
    <name>MeasureTexts</name>
    <message>
        <source>Volume %1</source>
        <translation>Volumen %1</translation>
    </message>
    <message>
        <source>no voxels</source>
        <translation>ningún vóxel</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>mean %1 ± %2%3</source>
        <translation>media %1 ± %2%3</translation>
    </message>
    <message>
        <source>HU </source>
        <translation>UH </translation>
    </message>
    <message>
        <source>value </source>
        <translation>valor </translation>
    </message>
    <message>
        <source>SUV %1 (%2)</source>
        <translation>SUV %1 (%2)</translation>
    </message>
    <message>
        <source>%1 at %2, %3, %4 mm</source>
        <translation>%1 en %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>%1, from %2 to %3%4</source>
        <translation>%1, de %2 a %3%4</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 pixels</source>
        <translation>%1 píxeles</translation>
    </message>
    <message>
        <source>%1 voxels</source>
        <translation>%1 vóxeles</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Cobb angle</source>
        <translation>Ángulo de Cobb</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Elipse</translation>
    </message>
    <message>
        <source>Freehand region</source>
        <translation>Región a mano alzada</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Flecha</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source> HU</source>
        <translation> UH</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>measure</source>
        <translation>medir</translation>
    </message>
</context>
<context>
    <name>OpenGLProblem</name>
    <message>
        <source>OpenGL 3.2 or later is needed, found %1; install or update the driver of the graphics card, or the package libgl1-mesa-dri, which draws without one</source>
        <translation>Se necesita OpenGL 3.2 o posterior y se encontró %1; instale o actualice el controlador de la tarjeta gráfica, o el paquete libgl1-mesa-dri, que dibuja sin ella</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>a display without GLX</source>
        <translation>una pantalla sin GLX</translation>
    </message>
</context>
<context>
    <name>OwnPresets</name>
    <message>
        <source>My look %1</source>
        <translation>Mi aspecto %1</translation>
    </message>
    <message>
        <source>A preset name must not begin with a dot or contain a slash.</source>
        <translation>El nombre de un preajuste no debe empezar por un punto ni contener una barra.</translation>
    </message>
    <message>
        <source>A preset named %1 already exists.</source>
        <translation>Ya existe un preajuste llamado %1.</translation>
    </message>
    <message>
        <source>Cannot rename the preset %1 to %2.</source>
        <translation>El preajuste %1 no se puede renombrar como %2.</translation>
    </message>
    <message>
        <source>Cannot remove the preset %1.</source>
        <translation>El preajuste %1 no se puede eliminar.</translation>
    </message>
</context>
<context>
    <name>PdfPages</name>
    <message>
        <source>Not for diagnostic use: made by a program that is not a medical device</source>
        <translation>No apto para diagnóstico: hecho por un programa que no es un producto sanitario</translation>
    </message>
</context>
<context>
    <name>PictureExport</name>
    <message>
        <source>Not for diagnostic use</source>
        <translation>No apto para diagnóstico</translation>
    </message>
</context>
<context>
    <name>PictureReport</name>
    <message>
        <source>VTK, GPU</source>
        <translation>VTK, GPU</translation>
    </message>
    <message>
        <source>VTK, CPU</source>
        <translation>VTK, CPU</translation>
    </message>
    <message>
        <source>%1
%2
error unknown</source>
        <translation>%1
%2
error desconocido</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>error about %1 %</source>
        <translation>error de un %1 % aproximadamente</translation>
    </message>
    <message>
        <source>
except at single pixels</source>
        <translation>
salvo en píxeles aislados</translation>
    </message>
    <message>
        <source>
mean of %1 frames</source>
        <translation>
media de %1 imágenes</translation>
    </message>
    <message>
        <source>error at most 1/%1, refined</source>
        <translation>error como máximo 1/%1, refinado</translation>
    </message>
    <message>
        <source>error at most 1/%1</source>
        <translation>error como máximo 1/%1</translation>
    </message>
    <message>
        <source>coarse voxels, error unknown</source>
        <translation>vóxeles de baja resolución, error desconocido</translation>
    </message>
    <message>
        <source>error at most %1 %, refining</source>
        <translation>error de %1 % como máximo, refinando</translation>
    </message>
    <message>
        <source>error not bounded</source>
        <translation>error no acotado</translation>
    </message>
    <message>
        <source>
Less error takes long, since its voxels do not fit in the memory:
allow more in the menu File, or zoom in.</source>
        <translation>
Un error menor tarda mucho, porque sus vóxeles no caben en la memoria:
permita más memoria en el menú Archivo o amplíe la imagen.</translation>
    </message>
    <message>
        <source>Nothing is visible: %1.</source>
        <translation>No se ve nada: %1.</translation>
    </message>
    <message>
        <source>masks not supported</source>
        <translation>sin máscaras</translation>
    </message>
    <message>
        <source>segments not supported</source>
        <translation>sin segmentos</translation>
    </message>
    <message>
        <source>regions not supported</source>
        <translation>sin regiones</translation>
    </message>
    <message>
        <source>blend mode not supported</source>
        <translation>sin este modo de mezcla</translation>
    </message>
    <message>
        <source>further scans not supported</source>
        <translation>sin otros estudios</translation>
    </message>
    <message>
        <source>shadows not supported</source>
        <translation>sin sombras</translation>
    </message>
    <message>
        <source>cubic interpolation not supported</source>
        <translation>sin interpolación cúbica</translation>
    </message>
    <message>
        <source>refining, %1 %</source>
        <translation>refinando, %1 %</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>no actualizado</translation>
    </message>
</context>
<context>
    <name>PresetTitles</name>
    <message>
        <source>CT airways</source>
        <translation>TC vías aéreas</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>TC hueso</translation>
    </message>
    <message>
        <source>CT implants</source>
        <translation>TC implantes</translation>
    </message>
    <message>
        <source>CT lungs</source>
        <translation>TC pulmones</translation>
    </message>
    <message>
        <source>CT maximum</source>
        <translation>TC máximo</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>TC piel</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>TC partes blandas</translation>
    </message>
    <message>
        <source>CT vessels</source>
        <translation>TC vasos</translation>
    </message>
    <message>
        <source>MR angiography</source>
        <translation>RM angiografía</translation>
    </message>
    <message>
        <source>MR head, T1</source>
        <translation>RM cabeza, T1</translation>
    </message>
    <message>
        <source>MR maximum</source>
        <translation>RM máximo</translation>
    </message>
    <message>
        <source>MR head, T2</source>
        <translation>RM cabeza, T2</translation>
    </message>
    <message>
        <source>the modality is %1</source>
        <translation>la modalidad es %1</translation>
    </message>
    <message>
        <source>the body part is %1</source>
        <translation>la región del cuerpo es %1</translation>
    </message>
    <message>
        <source>the file mentions a contrast agent</source>
        <translation>el archivo menciona un medio de contraste</translation>
    </message>
    <message>
        <source>the sequence times in the file suggest %1</source>
        <translation>los tiempos de la secuencia en el archivo indican %1</translation>
    </message>
    <message>
        <source>it contains metal, denser than any bone</source>
        <translation>contiene metal, más denso que cualquier hueso</translation>
    </message>
    <message>
        <source>its values reach down to air in CT</source>
        <translation>sus valores llegan hasta los del aire en TC</translation>
    </message>
    <message>
        <source>its values do not look like CT</source>
        <translation>sus valores no parecen de TC</translation>
    </message>
    <message>
        <source>PET maximum</source>
        <translation>PET, máximo</translation>
    </message>
    <message>
        <source>the body part is %1, but the file&apos;s window is for soft tissue</source>
        <translation>la región del cuerpo es %1, pero la ventana del archivo es para tejido blando</translation>
    </message>
    <message>
        <source>the body part is %1, but few values are those of lungs</source>
        <translation>la región del cuerpo es %1, pero pocos valores son de pulmones</translation>
    </message>
    <message>
        <source>PET hot</source>
        <translation>PET cálido</translation>
    </message>
</context>
<context>
    <name>RecentScans</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>opened %1</source>
        <translation>abierto %1</translation>
    </message>
</context>
<context>
    <name>ScanReport</name>
    <message>
        <source>custom look</source>
        <translation>aspecto propio</translation>
    </message>
    <message>
        <source>%1, edited</source>
        <translation>%1, editado</translation>
    </message>
    <message>
        <source>ambient %1, diffuse %2, specular %3, power %4</source>
        <translation>ambiente %1, difuso %2, especular %3, exponente %4</translation>
    </message>
    <message>
        <source>none: unshaded colours</source>
        <translation>ninguna: colores sin sombreado</translation>
    </message>
    <message>
        <source>at most 1/%1 of full brightness in any colour of 99.9 % of the pixels, estimated</source>
        <translation>como máximo 1/%1 del brillo total en cada color del 99,9 % de los píxeles, estimado</translation>
    </message>
    <message>
        <source>not bounded</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalidad</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Vóxeles</translation>
    </message>
    <message>
        <source>Voxel spacing</source>
        <translation>Distancia entre vóxeles</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Modo de mezcla</translation>
    </message>
    <message>
        <source>Opacity per</source>
        <translation>Opacidad por</translation>
    </message>
    <message>
        <source>Opacity by gradient</source>
        <translation>Opacidad por gradiente</translation>
    </message>
    <message>
        <source>off</source>
        <translation>no</translation>
    </message>
    <message>
        <source>on</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Luz</translation>
    </message>
    <message>
        <source>Cut planes</source>
        <translation>Planos de corte</translation>
    </message>
    <message>
        <source>Scissors cuts</source>
        <translation>Cortes con tijeras</translation>
    </message>
    <message>
        <source>%1, a coarse copy of the volume</source>
        <translation>%1, una copia aproximada del volumen</translation>
    </message>
    <message>
        <source>Promised error</source>
        <translation>Error prometido</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Volume report</source>
        <translation>Informe del volumen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Rendering settings</source>
        <translation>Ajustes de la representación</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Table and clothes</source>
        <translation>Mesa y ropa</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>quitadas</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>mostradas</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
    </message>
    <message>
        <source>Segments of volume %1</source>
        <translation>Segmentos del volumen %1</translation>
    </message>
</context>
<context>
    <name>ScissorsTool</name>
    <message>
        <source>keep the inside</source>
        <translation>conservar el interior</translation>
    </message>
    <message>
        <source>cut out</source>
        <translation>cortar</translation>
    </message>
</context>
<context>
    <name>SliceCorners</name>
    <message>
        <source>W %1 L %2</source>
        <translation>A %1 N %2</translation>
    </message>
    <message>
        <source>Zoom %1 %</source>
        <translation>Zoom %1 %</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Corte %1 de %2</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Slab %1 mm</source>
        <translation>Grosor %1 mm</translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation>%1 µm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Oblicuo</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>window and level</source>
        <translation>ventana y nivel</translation>
    </message>
</context>
<context>
    <name>SliceWindows</name>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Lungs</source>
        <translation>Pulmones</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastino</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Hueso</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Cerebro</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>Subdural</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Ictus</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Hígado</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Vasos</translation>
    </message>
</context>
<context>
    <name>StudyIndex</name>
    <message>
        <source>The study list &quot;%1&quot; cannot be used: %2. Remove the list and add its folders again.</source>
        <translation>La lista de estudios «%1» no se puede usar: %2. Elimine la lista y vuelva a añadir sus carpetas.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read: it is not there, or its disk is away. What the list knows of it stays.</source>
        <translation>No se puede leer la carpeta «%1»: no existe o falta su disco. Sus entradas siguen en la lista.</translation>
    </message>
</context>
<context>
    <name>Theme</name>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>As on the &amp;desktop</source>
        <translation>Como en el &amp;escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>High &amp;contrast</source>
        <translation>Al&amp;to contraste</translation>
    </message>
</context>
<context>
    <name>TimeTexts</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 s, %2</source>
        <translation>%1 s, %2</translation>
    </message>
    <message>
        <source>A movie lasts at most an hour, and this one would be longer. Choose a speed beside the slider of the times.</source>
        <translation>Una película dura como máximo una hora, y esta sería más larga. Elija una velocidad junto al control de los tiempos.</translation>
    </message>
</context>
<context>
    <name>TransferFunctionEditor</name>
    <message>
        <source>opacity %1</source>
        <translation>opacidad %1</translation>
    </message>
    <message>
        <source>%1 % of voxels, %2 % above</source>
        <translation>%1 % de los vóxeles, %2 % por encima</translation>
    </message>
    <message>
        <source>point %1 of %2, %3, %4</source>
        <translation>punto %1 de %2, %3, %4</translation>
    </message>
    <message>
        <source>surface %1 of %2, %3, %4</source>
        <translation>superficie %1 de %2, %3, %4</translation>
    </message>
    <message>
        <source>colour %1 of %2, %3</source>
        <translation>color %1 de %2, %3</translation>
    </message>
</context>
<context>
    <name>Turntable</name>
    <message>
        <source>the disk is full, or its end was not written</source>
        <translation>el disco está lleno o no se escribió el final</translation>
    </message>
    <message>
        <source>Cannot write %1</source>
        <translation>No se puede escribir %1</translation>
    </message>
    <message>
        <source>ffmpeg could not be started: %1</source>
        <translation>no se pudo iniciar ffmpeg: %1</translation>
    </message>
    <message>
        <source>MP4 needs the program ffmpeg, which is not installed</source>
        <translation>MP4 necesita el programa ffmpeg, que no está instalado</translation>
    </message>
    <message>
        <source>ffmpeg exited with code %1</source>
        <translation>ffmpeg terminó con el código %1</translation>
    </message>
    <message>
        <source>ffmpeg reports: %1</source>
        <translation>ffmpeg informa: %1</translation>
    </message>
    <message>
        <source>Movie, MP4 (*.mp4)</source>
        <translation>Película, MP4 (*.mp4)</translation>
    </message>
    <message>
        <source>Movie, Ogg Theora (*.ogv)</source>
        <translation>Película, Ogg Theora (*.ogv)</translation>
    </message>
    <message>
        <source>Images (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Cannot write %1: %2</source>
        <translation>No se puede escribir %1: %2</translation>
    </message>
</context>
<context>
    <name>WalkTool</name>
    <message>
        <source>walk</source>
        <translation>caminar</translation>
    </message>
</context>
<context>
    <name>WordsEditor</name>
    <message>
        <source>Words</source>
        <translation>Palabras</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveChoice</name>
    <message>
        <source>Edit…</source>
        <translation>Editar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo de imágenes</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveForm</name>
    <message>
        <source>A file in PEM with our certificate and its private key without a password, if the archive asks for it; encrypted C-MOVE needs it</source>
        <translation>Un fichero PEM con nuestro certificado y su clave privada sin contraseña, si el archivo lo pide; C-MOVE cifrado lo necesita</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Nuestro certificado</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Cifrado (TLS)</translation>
    </message>
    <message>
        <source>Set up an archive</source>
        <translation>Configurar un archivo de imágenes</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Asks the archive to answer</source>
        <translation>Pide al archivo que responda</translation>
    </message>
    <message>
        <source>DICOM (C-FIND, C-GET, C-STORE)</source>
        <translation>DICOM (C-FIND, C-GET, C-STORE)</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>none, by C-GET</source>
        <translation>ninguno, con C-GET</translation>
    </message>
    <message>
        <source>For archives that send only by C-MOVE, to a port that they know by our title</source>
        <translation>Para archivos que solo envían con C-MOVE, a un puerto que conocen por nuestro título</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>The password is asked for when it is needed, and is not kept</source>
        <translation>La contraseña se pide cuando hace falta y no se guarda</translation>
    </message>
    <message>
        <source>file in PEM; none for a known authority</source>
        <translation>fichero PEM; ninguno si la autoridad es conocida</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protocolo</translation>
    </message>
    <message>
        <source>URL</source>
        <translation>URL</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Servidor</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Title of the archive (AE)</source>
        <translation>Título del archivo (AE)</translation>
    </message>
    <message>
        <source>Our title (AE)</source>
        <translation>Nuestro título (AE)</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>Puerto para C-MOVE</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>Waiting for the archive…</source>
        <translation>Esperando al archivo…</translation>
    </message>
    <message>
        <source>The archive answers.</source>
        <translation>El archivo responde.</translation>
    </message>
</context>
<context>
    <name>varimarch::ArchiveWindow</name>
    <message>
        <source>Unreadable name</source>
        <translation>Nombre ilegible</translation>
    </message>
    <message>
        <source>Texts of %1 entries are left out: they are in an unknown set of characters, or in another than the archive says.</source>
        <translation>Faltan textos de %1 entradas: están en un juego de caracteres desconocido o distinto del que indica el archivo.</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Sin nombre</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo de imágenes</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudios</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Paciente</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalidad</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>Search for studies. What you open is deleted at the end, unless you keep it.</source>
        <translation>Busque estudios. Lo que abra se borra al final, si no lo conserva.</translation>
    </message>
    <message>
        <source>Add an archive (PACS) first. Its administrator knows host, port and titles.</source>
        <translation>Añada primero un archivo (PACS). Su administrador conoce el servidor, el puerto y los títulos.</translation>
    </message>
    <message>
        <source>It was cancelled</source>
        <translation>Se ha cancelado</translation>
    </message>
    <message>
        <source>beginning, as DOE</source>
        <translation>comienzo, como PER</translation>
    </message>
    <message>
        <source>20261126, or 20260101-20261231</source>
        <translation>20261126 o 20260101-20261231</translation>
    </message>
    <message>
        <source>CT, MR …</source>
        <translation>CT, MR…</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Keep in…</source>
        <translation>Conservar en…</translation>
    </message>
    <message>
        <source>Fetches the study or the series into a folder of yours, and opens it</source>
        <translation>Trae el estudio o la serie a una carpeta suya y lo abre</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Fetches the study or the series, which is deleted at the end</source>
        <translation>Trae el estudio o la serie, que se borra al final</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>Studies: %1</source>
        <translation>Estudios: %1</translation>
    </message>
    <message>
        <source>Series: %1</source>
        <translation>Series: %1</translation>
    </message>
    <message>
        <source>Keep the scan in a folder</source>
        <translation>Conservar el estudio en una carpeta</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made; choose another.</source>
        <translation>No se puede crear la carpeta «%1»; elija otra.</translation>
    </message>
    <message>
        <source>Choose a study or a series first.</source>
        <translation>Elija primero un estudio o una serie.</translation>
    </message>
    <message>
        <source>Fetching…</source>
        <translation>Transfiriendo…</translation>
    </message>
    <message>
        <source>Fetched</source>
        <translation>Transferido</translation>
    </message>
</context>
<context>
    <name>varimarch::BackgroundTask</name>
    <message>
        <source>There is not enough memory.</source>
        <translation>No hay memoria suficiente.</translation>
    </message>
</context>
<context>
    <name>varimarch::BenchmarkDialog</name>
    <message>
        <source>Median of %1 views: ours %2 ms, %3 %4 ms, %5 times as long. Difference: RMSE %6, largest %7, in 1/255.</source>
        <translation>Mediana de %1 vistas: el nuestro %2 ms, %3 %4 ms, %5 veces más. Diferencia: RMSE %6, máxima %7, en 1/255.</translation>
    </message>
    <message>
        <source>Angle [°]</source>
        <translation>Ángulo [°]</translation>
    </message>
    <message>
        <source>Ours [ms]</source>
        <translation>Nuestro [ms]</translation>
    </message>
    <message>
        <source>VTK&apos;s [ms]</source>
        <translation>De VTK [ms]</translation>
    </message>
    <message>
        <source>RMSE</source>
        <translation>RMSE</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Máxima</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Prueba de rendimiento</translation>
    </message>
    <message>
        <source>Renders the scene from all around with our mapper and with VTK&apos;s, and compares times and images.</source>
        <translation>Dibuja la escena desde todos los lados con nuestro mapper y el de VTK, y compara tiempos e imágenes.</translation>
    </message>
    <message>
        <source>VTK&apos;s GPU mapper</source>
        <translation>mapper de GPU de VTK</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper</source>
        <translation>mapper de CPU de VTK</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparar con</translation>
    </message>
    <message>
        <source>Number of views</source>
        <translation>Número de vistas</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper does not support this blend mode; choose VTK&apos;s GPU mapper.</source>
        <translation>El mapper de CPU de VTK no admite este modo de mezcla; elija el mapper de GPU de VTK.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Export the benchmark</source>
        <translation>Exportar la prueba de rendimiento</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>No se puede exportar</translation>
    </message>
    <message>
        <source>A turn around a volume of %1 x %2 x %3 voxels, rendered at %4 x %5 pixels by our mapper and by %6.</source>
        <translation>Un giro alrededor de un volumen de %1 x %2 x %3 vóxeles, dibujado con %4 x %5 píxeles por nuestro mapper y por %6.</translation>
    </message>
    <message>
        <source>Report (*.pdf)</source>
        <translation>Informe (*.pdf)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>VTK&apos;s CPU mapper does not support segments; choose VTK&apos;s GPU mapper.</source>
        <translation>El mapper de CPU de VTK no admite segmentos; elija el mapper de GPU de VTK.</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
</context>
<context>
    <name>varimarch::BlendingForm</name>
    <message>
        <source>Composite</source>
        <translation>Composición</translation>
    </message>
    <message>
        <source>Translucent material with the opacities of the curve</source>
        <translation>Material translúcido con las opacidades de la curva</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>The largest value along each ray: vessels, implants (MIP)</source>
        <translation>El valor mayor en cada rayo: vasos, implantes (MIP)</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>The smallest value along each ray: airways (MinIP)</source>
        <translation>El valor menor en cada rayo: vías aéreas (MinIP)</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Promedio</translation>
    </message>
    <message>
        <source>The mean along each ray, as in a thick slice</source>
        <translation>La media en cada rayo: como un corte grueso</translation>
    </message>
    <message>
        <source>Additive</source>
        <translation>Aditiva</translation>
    </message>
    <message>
        <source>The sum along each ray, as in an X-ray image</source>
        <translation>La suma en cada rayo: como una radiografía</translation>
    </message>
    <message>
        <source>Isosurfaces</source>
        <translation>Isosuperficies</translation>
    </message>
    <message>
        <source>Surfaces of equal value, each with its colour and opacity</source>
        <translation>Superficies de igual valor, cada una con su color y opacidad</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Modo de mezcla</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness of material that has the opacities of the curve</source>
        <translation>El grosor de material que tiene las opacidades de la curva</translation>
    </message>
    <message>
        <source>opacity distance</source>
        <translation>distancia de opacidad</translation>
    </message>
    <message>
        <source>Opacity per</source>
        <translation>Opacidad por</translation>
    </message>
    <message>
        <source>Values outside this range do not count in the mean</source>
        <translation>Los valores fuera de este intervalo no cuentan en la media</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Valores desde</translation>
    </message>
    <message>
        <source>blend mode</source>
        <translation>modo de mezcla</translation>
    </message>
    <message>
        <source>range of averaged values</source>
        <translation>intervalo de valores promediados</translation>
    </message>
    <message>
        <source>Smallest value of the mean</source>
        <translation>Valor mínimo de la media</translation>
    </message>
    <message>
        <source>Largest value of the mean</source>
        <translation>Valor máximo de la media</translation>
    </message>
    <message>
        <source>. Presets set it by the size of the volume, which is not known to show a patient</source>
        <translation>. Los preajustes la eligen según el tamaño del volumen, del que no se sabe si muestra a un paciente</translation>
    </message>
</context>
<context>
    <name>varimarch::ChannelsBox</name>
    <message>
        <source>The volume is drawn in its own colours. The curve is their opacity.</source>
        <translation>El volumen tiene sus propios colores. La curva es su opacidad.</translation>
    </message>
    <message>
        <source>Draws the channel</source>
        <translation>Dibuja el canal</translation>
    </message>
    <message>
        <source>Colour of the channel</source>
        <translation>Color del canal</translation>
    </message>
    <message>
        <source>Colour of channel %1</source>
        <translation>Color del canal %1</translation>
    </message>
    <message>
        <source>Opacity of channel %1</source>
        <translation>Opacidad del canal %1</translation>
    </message>
    <message>
        <source>Factor of the opacities of the curve</source>
        <translation>Factor de las opacidades de la curva</translation>
    </message>
    <message>
        <source>channel</source>
        <translation>canal</translation>
    </message>
    <message>
        <source>opacity of a channel</source>
        <translation>opacidad de un canal</translation>
    </message>
    <message>
        <source>Values from</source>
        <translation>Valores desde</translation>
    </message>
    <message>
        <source>First value of channel %1</source>
        <translation>Primer valor del canal %1</translation>
    </message>
    <message>
        <source>Last value of channel %1</source>
        <translation>Último valor del canal %1</translation>
    </message>
    <message>
        <source>The curve reaches from the first to the last of these values</source>
        <translation>La curva va del primero al último de estos valores</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>values of a channel</source>
        <translation>valores de un canal</translation>
    </message>
    <message>
        <source>colour of a channel</source>
        <translation>color de un canal</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Canal %1</translation>
    </message>
</context>
<context>
    <name>varimarch::ClippingRangeBox</name>
    <message>
        <source>Distance from the eye</source>
        <translation>Distancia al ojo</translation>
    </message>
    <message>
        <source>Shows only what lies between two distances from the eye</source>
        <translation>Muestra solo lo que está entre dos distancias al ojo</translation>
    </message>
    <message>
        <source>Nearest</source>
        <translation>Mínima</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Máxima</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>distance from the eye</source>
        <translation>distancia al ojo</translation>
    </message>
    <message>
        <source>limit the distance from the eye</source>
        <translation>limitar la distancia al ojo</translation>
    </message>
    <message>
        <source>show all distances</source>
        <translation>mostrar todas las distancias</translation>
    </message>
</context>
<context>
    <name>varimarch::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Buscar una orden</translation>
    </message>
    <message>
        <source>Some letters of the command, such as &quot;panel look&quot;</source>
        <translation>Algunas letras de la orden, como «panel asp»</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>varimarch::ComparisonView</name>
    <message>
        <source>Divider between our image and VTK&apos;s</source>
        <translation>Divisor entre nuestra imagen y la de VTK</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>RMSE %1, largest %2, in 1/255. Ours %3 ms, VTK&apos;s %4 ms.</source>
        <translation>RMSE %1, máxima %2, en 1/255. La nuestra %3 ms, la de VTK %4 ms.</translation>
    </message>
    <message>
        <source>Difference (out of date)</source>
        <translation>Diferencia (no actualizada)</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>Sin diferencia</translation>
    </message>
    <message>
        <source>There is no difference, because VTK&apos;s mapper does not draw the whole scene: %1.</source>
        <translation>No se calcula la diferencia, porque el mapper de VTK no dibuja toda la escena: %1.</translation>
    </message>
</context>
<context>
    <name>varimarch::CurvedView</name>
    <message>
        <source>Volume along the curve</source>
        <translation>Volumen a lo largo de la curva</translation>
    </message>
    <message>
        <source>Choose Annotate, Curve, and click along a vessel or the jaw in the slices.</source>
        <translation>Elija Anotar, Curva, y haga clic a lo largo de un vaso o de la mandíbula en los cortes.</translation>
    </message>
    <message>
        <source>%1 mm, turned by %2°</source>
        <translation>%1 mm, girado %2°</translation>
    </message>
    <message>
        <source>, slab %1 mm</source>
        <translation>, grosor %1 mm</translation>
    </message>
    <message>
        <source>%1 mm along the curve; %2</source>
        <translation>%1 mm a lo largo de la curva; %2</translation>
    </message>
    <message>
        <source>move the crosshair</source>
        <translation>mover la cruz</translation>
    </message>
    <message>
        <source>turn the cut about the curve</source>
        <translation>girar el corte en torno a la curva</translation>
    </message>
    <message>
        <source>Straightened</source>
        <translation>Enderezado</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Estirado</translation>
    </message>
    <message>
        <source>The context menu chooses between the straightened and the stretched volume</source>
        <translation>El menú contextual elige entre el volumen enderezado y el estirado</translation>
    </message>
    <message>
        <source>, stretched</source>
        <translation>, estirado</translation>
    </message>
</context>
<context>
    <name>varimarch::CutsPanel</name>
    <message>
        <source>side %1 cut away</source>
        <translation>lado %1 cortado</translation>
    </message>
    <message>
        <source>Cut away the left half</source>
        <translation>Quitar la mitad izquierda</translation>
    </message>
    <message>
        <source>Cut away the right half</source>
        <translation>Quitar la mitad derecha</translation>
    </message>
    <message>
        <source>Cut away the front half</source>
        <translation>Quitar la mitad anterior</translation>
    </message>
    <message>
        <source>Cut away the back half</source>
        <translation>Quitar la mitad posterior</translation>
    </message>
    <message>
        <source>Cut away the upper half</source>
        <translation>Quitar la mitad superior</translation>
    </message>
    <message>
        <source>Cut away the lower half</source>
        <translation>Quitar la mitad inferior</translation>
    </message>
    <message>
        <source>Cut away the half facing me</source>
        <translation>Quitar la mitad que me mira</translation>
    </message>
    <message>
        <source>Cut away…</source>
        <translation>Cortar…</translation>
    </message>
    <message numerus="yes">
        <source>Adds a plane that cuts away one side, up to %n planes</source>
        <translation>
            <numerusform>Un plano quita un lado, hasta %n de ellos</numerusform>
            <numerusform>Un plano quita un lado, hasta %n de ellos</numerusform>
        </translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Planos</translation>
    </message>
    <message>
        <source>Depth of the plane</source>
        <translation>Profundidad del plano</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Invertir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja</translation>
    </message>
    <message>
        <source>Whole volume</source>
        <translation>Todo el volumen</translation>
    </message>
    <message>
        <source>show the whole volume</source>
        <translation>mostrar todo el volumen</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Tijeras</translation>
    </message>
    <message>
        <source>Remove all cuts</source>
        <translation>Quitar todos los cortes</translation>
    </message>
    <message>
        <source>remove all scissors cuts</source>
        <translation>quitar todos los cortes con tijeras</translation>
    </message>
    <message>
        <source>Scissors cuts: %1</source>
        <translation>Cortes con tijeras: %1</translation>
    </message>
    <message>
        <source>cut away the half facing me</source>
        <translation>quitar la mitad que me mira</translation>
    </message>
    <message>
        <source>move a plane</source>
        <translation>mover un plano</translation>
    </message>
    <message>
        <source>flip a plane</source>
        <translation>invertir un plano</translation>
    </message>
    <message>
        <source>remove a plane</source>
        <translation>eliminar un plano</translation>
    </message>
    <message>
        <source>crop</source>
        <translation>recortar</translation>
    </message>
    <message>
        <source>Remove table, head rest and clothes</source>
        <translation>Quitar la mesa, el reposacabezas y la ropa</translation>
    </message>
    <message>
        <source>Shows the body of a CT scan alone</source>
        <translation>Muestra solo el cuerpo de un estudio de TC</translation>
    </message>
    <message>
        <source>remove the table</source>
        <translation>quitar la mesa</translation>
    </message>
    <message>
        <source>show the table</source>
        <translation>mostrar la mesa</translation>
    </message>
    <message>
        <source>Choose Scissors or Keep inside above, then draw around the part to remove or to keep.</source>
        <translation>Elija arriba Tijeras o Conservar el interior, y dibuje alrededor de la parte que se quita o se conserva.</translation>
    </message>
    <message>
        <source>Remove face</source>
        <translation>Quitar la cara</translation>
    </message>
    <message>
        <source>Cuts the front of the head away in the 3D view, to %1 mm behind its smoothed surface. This is no anonymization: look at the image, ears and bones stay, and slices show the face.</source>
        <translation>Recorta en la vista 3D la parte delantera de la cabeza, hasta %1 mm detrás de su superficie suavizada. Esto no es una anonimización: revise la imagen, las orejas y los huesos quedan, y los cortes muestran la cara.</translation>
    </message>
    <message>
        <source>remove the face</source>
        <translation>quitar la cara</translation>
    </message>
    <message>
        <source>show the face</source>
        <translation>mostrar la cara</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Delante</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Detrás</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Cabeza</translation>
    </message>
</context>
<context>
    <name>varimarch::ExportActions</name>
    <message>
        <source>Export an &amp;image…</source>
        <translation>Exportar una &amp;imagen…</translation>
    </message>
    <message>
        <source>Send the i&amp;mage to an archive…</source>
        <translation>Enviar la i&amp;magen a un archivo PACS…</translation>
    </message>
    <message>
        <source>Export a &amp;turntable…</source>
        <translation>Exportar un gir&amp;o…</translation>
    </message>
    <message>
        <source>&amp;Export the times…</source>
        <translation>Exportar los ti&amp;empos…</translation>
    </message>
    <message>
        <source>Export a re&amp;port…</source>
        <translation>Exportar un in&amp;forme…</translation>
    </message>
    <message>
        <source>Export the &amp;cuts…</source>
        <translation>E&amp;xportar los cortes…</translation>
    </message>
    <message>
        <source>Export a cha&amp;nge of the look from</source>
        <translation>Exportar u&amp;n cambio del aspecto desde</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>No se puede exportar</translation>
    </message>
    <message>
        <source>Export a turntable</source>
        <translation>Exportar un giro</translation>
    </message>
    <message>
        <source>Rendering the turntable</source>
        <translation>Dibujando un giro</translation>
    </message>
    <message>
        <source>Export the times</source>
        <translation>Exportar los tiempos</translation>
    </message>
    <message>
        <source>Rendering the times</source>
        <translation>Calculando los tiempos</translation>
    </message>
    <message>
        <source>An added scan stays at the time before, since another could not be read: %1</source>
        <translation>Un estudio añadido permanece en el tiempo anterior, porque no se pudo leer otro: %1</translation>
    </message>
    <message>
        <source>Export a report</source>
        <translation>Exportar un informe</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export the cuts</source>
        <translation>Exportar los cortes</translation>
    </message>
    <message>
        <source>Rendering the cuts</source>
        <translation>Calculando los cortes</translation>
    </message>
    <message>
        <source>Export a change of the look</source>
        <translation>Exportar un cambio del aspecto</translation>
    </message>
    <message>
        <source>Rendering the change</source>
        <translation>Calculando el cambio</translation>
    </message>
    <message>
        <source>The current look cannot change: it is no composite, or has regions</source>
        <translation>El aspecto actual no puede cambiar: no es una composición o tiene regiones</translation>
    </message>
</context>
<context>
    <name>varimarch::ExportDialog</name>
    <message>
        <source>Transparent background (PNG)</source>
        <translation>Fondo transparente (PNG)</translation>
    </message>
    <message>
        <source>Directions and measurements</source>
        <translation>Direcciones y mediciones</translation>
    </message>
    <message>
        <source>Export an image</source>
        <translation>Exportar una imagen</translation>
    </message>
    <message>
        <source> pixels</source>
        <translation> píxeles</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>DICOM without data of the patient (*.dcm)</source>
        <translation>DICOM sin datos del paciente (*.dcm)</translation>
    </message>
    <message>
        <source>Cannot export</source>
        <translation>No se puede exportar</translation>
    </message>
</context>
<context>
    <name>varimarch::FusionBar</name>
    <message>
        <source>Checkerboard</source>
        <translation>Tablero</translation>
    </message>
    <message>
        <source>Blend of the volumes</source>
        <translation>Mezcla de los volúmenes</translation>
    </message>
    <message>
        <source>0 shows the first volume, 1 those over it</source>
        <translation>0 muestra el primer volumen, 1 los que están encima</translation>
    </message>
    <message>
        <source>Shows the volumes in alternate squares of 20 mm</source>
        <translation>Muestra los volúmenes en cuadrados alternos de 20 mm</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>blend of the volumes</source>
        <translation>mezcla de los volúmenes</translation>
    </message>
    <message>
        <source>checkerboard</source>
        <translation>tablero</translation>
    </message>
</context>
<context>
    <name>varimarch::GradientOpacityBox</name>
    <message>
        <source>Opacity by gradient</source>
        <translation>Opacidad por gradiente</translation>
    </message>
    <message>
        <source>Makes edges between materials stand out from homogeneous regions</source>
        <translation>Destaca los bordes entre materiales sobre lo homogéneo</translation>
    </message>
    <message>
        <source>switch off opacity by gradient</source>
        <translation>desactivar la opacidad por gradiente</translation>
    </message>
    <message>
        <source>switch on opacity by gradient</source>
        <translation>activar la opacidad por gradiente</translation>
    </message>
    <message>
        <source>HU/mm</source>
        <translation>UH/mm</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>por mm</translation>
    </message>
</context>
<context>
    <name>varimarch::HelpActions</name>
    <message>
        <source>&lt;b&gt;Not for diagnostic use.&lt;/b&gt; This program is not a medical device. It must not be used to diagnose, to plan or to guide a treatment.</source>
        <translation>&lt;b&gt;No apto para diagnóstico.&lt;/b&gt; Este programa no es un producto sanitario. No debe usarse para diagnosticar ni para planificar o guiar un tratamiento.</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>&amp;Buscar una orden…</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>Ratón y &amp;teclas</translation>
    </message>
    <message>
        <source>&amp;Two-minute tour</source>
        <translation>Recorrido de &amp;dos minutos</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>Open the l&amp;og folder</source>
        <translation>Abrir la carpeta del &amp;registro</translation>
    </message>
    <message>
        <source>&amp;About Varimarch</source>
        <translation>&amp;Acerca de Varimarch</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>I understand</source>
        <translation>Entendido</translation>
    </message>
    <message>
        <source>As on the &amp;desktop</source>
        <translation>Como en el &amp;escritorio</translation>
    </message>
    <message>
        <source>The program will use the desktop&apos;s language after a restart</source>
        <translation>El programa usará el idioma del escritorio tras reiniciarse</translation>
    </message>
    <message>
        <source>The program will use %1 after a restart</source>
        <translation>El programa usará %1 tras reiniciarse</translation>
    </message>
    <message>
        <source>The volume</source>
        <translation>El volumen</translation>
    </message>
    <message>
        <source>Drag to turn it, drag with Shift or the middle button to move it, and turn the wheel to come nearer. A double-click shows it alone, another one all views again.</source>
        <translation>Arrastre para girarlo, arrastre con Mayús o con el botón central para moverlo y use la rueda para acercarse. Un doble clic lo muestra solo; otro, de nuevo todas las vistas.</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>The wheel goes through the slices. Drag the cross to move all three, its arms to tilt them, and drag with the right button for brightness and contrast. Number keys choose a usual window.</source>
        <translation>La rueda recorre los cortes. Arrastre la cruz para mover los tres, sus brazos para inclinarlos y, con el botón derecho, para el brillo y el contraste. Las teclas numéricas eligen una ventana habitual.</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Aspectos</translation>
    </message>
    <message>
        <source>Each image is this scan with another look. Click one; Ctrl+Z takes it back, as it does every edit.</source>
        <translation>Cada imagen es este estudio con otro aspecto. Haga clic en una; Ctrl+Z lo deshace, como todo cambio.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Función de transferencia</translation>
    </message>
    <message>
        <source>The curve says how opaque each value is, over the histogram of the scan. Drag its points, click to add one, and double-click a point for its numbers.</source>
        <translation>La curva indica cuán opaco es cada valor, sobre el histograma del estudio. Arrastre sus puntos, haga clic para añadir uno y doble clic en un punto para ver sus números.</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Remove the table with one click, drag a box or a plane in the volume, or cut with the scissors of the tool bar.</source>
        <translation>Quite la mesa con un clic, arrastre una caja o un plano en el volumen, o corte con las tijeras de la barra de herramientas.</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Choose a measurement in the tool bar and drag in a slice or in the volume. All of them are listed here and in reports.</source>
        <translation>Elija una medición en la barra de herramientas y arrastre en un corte o en el volumen. Todas figuran aquí en una lista y en los informes.</translation>
    </message>
    <message>
        <source>Everything else</source>
        <translation>Todo lo demás</translation>
    </message>
    <message>
        <source>Ctrl+K finds any command by a word, and F1 lists what the mouse and the keys do. The menu File saves sessions, images and reports.</source>
        <translation>Ctrl+K encuentra cualquier orden por una palabra y F1 muestra qué hacen el ratón y las teclas. El menú Archivo guarda sesiones, imágenes e informes.</translation>
    </message>
    <message>
        <source>About Varimarch</source>
        <translation>Acerca de Varimarch</translation>
    </message>
    <message>
        <source>&lt;b&gt;Varimarch %1&lt;/b&gt;&lt;p&gt;Shows CT and MR volumes with a promised error.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Varimarch %1&lt;/b&gt;&lt;p&gt;Muestra volúmenes de TC y RM con un error prometido.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>varimarch::KeyImagesBox</name>
    <message>
        <source>Key images</source>
        <translation>Imágenes clave</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Ir</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Tools, Mark a key image adds the view that was clicked last. Reports show all of them.</source>
        <translation>Herramientas, Marcar una imagen clave añade la última vista en la que se hizo clic. Los informes las muestran todas.</translation>
    </message>
    <message>
        <source>mark a key image</source>
        <translation>marcar una imagen clave</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>renombrar</translation>
    </message>
    <message>
        <source>go to a key image</source>
        <translation>ir a una imagen clave</translation>
    </message>
    <message>
        <source>remove a key image</source>
        <translation>eliminar una imagen clave</translation>
    </message>
</context>
<context>
    <name>varimarch::LightEffectsBox</name>
    <message>
        <source>Shadows</source>
        <translation>Sombras</translation>
    </message>
    <message>
        <source>scattering</source>
        <translation>dispersión</translation>
    </message>
    <message>
        <source>The part of the light that matter scatters and surfaces do not reflect; 0 is off.</source>
        <translation>La parte de la luz que la materia dispersa y las superficies no reflejan; 0 es nada.</translation>
    </message>
    <message>
        <source>Scattered light mostly goes back below 0, and straight on above.</source>
        <translation>Por debajo de 0 la luz dispersada vuelve en su mayoría; por encima sigue recta.</translation>
    </message>
    <message>
        <source>How far matter dims scattered light without shadows: 0 not at all, 1 everywhere.</source>
        <translation>Hasta dónde la materia atenúa la luz dispersada sin sombras: 0 nada, 1 en todas partes.</translation>
    </message>
    <message>
        <source>Scattering</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Hacia delante</translation>
    </message>
    <message>
        <source>Dimmed within</source>
        <translation>Atenuada hasta</translation>
    </message>
    <message>
        <source>Light that suits the look</source>
        <translation>Luz adecuada a la apariencia</translation>
    </message>
    <message>
        <source>Replaces all of this by the light of the preset.</source>
        <translation>Sustituye todo esto por la luz del preajuste.</translation>
    </message>
    <message>
        <source>light of the preset</source>
        <translation>luz del preajuste</translation>
    </message>
    <message>
        <source>How dark the shadows are that volumes cast on themselves and on each other, from lights that are not at the eye; 0 is off. An image takes about three times as long.</source>
        <translation>Cómo de oscuras son las sombras que los volúmenes proyectan sobre sí mismos y unos sobre otros, de luces que no están en el ojo; 0 es apagado. Una imagen tarda unas tres veces más.</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>sombras</translation>
    </message>
    <message>
        <source>ambient occlusion</source>
        <translation>oclusión ambiental</translation>
    </message>
    <message>
        <source>How much darker places are that see little of what is around the volume; 0 is off.</source>
        <translation>Cuánto más oscuros son los lugares que ven poco de lo que rodea al volumen; 0 es desactivado.</translation>
    </message>
    <message>
        <source>Matter farther away does not occlude. 0 stands for 16 voxels.</source>
        <translation>La materia más lejana no ocluye. 0 equivale a 16 vóxeles.</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Oclusión</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>varimarch::LightsPanel</name>
    <message>
        <source>At the eye</source>
        <translation>En el ojo</translation>
    </message>
    <message>
        <source>Turns with the camera</source>
        <translation>Gira con la cámara</translation>
    </message>
    <message>
        <source>Direction in the patient</source>
        <translation>Dirección en el paciente</translation>
    </message>
    <message>
        <source>Point in the patient</source>
        <translation>Punto en el paciente</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Luces</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Añadir una luz</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>intensity of a light</source>
        <translation>intensidad de una luz</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>direction of a light</source>
        <translation>dirección de una luz</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Hacia la derecha</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Hacia arriba</translation>
    </message>
    <message>
        <source>Left, back, head of the patient [mm]</source>
        <translation>Izquierda, espalda, cabeza del paciente [mm]</translation>
    </message>
    <message>
        <source>place of a light</source>
        <translation>lugar de una luz</translation>
    </message>
    <message>
        <source>Move to the crosshair of the slices</source>
        <translation>Mover a la cruz de los cortes</translation>
    </message>
    <message>
        <source>Place [mm]</source>
        <translation>Lugar [mm]</translation>
    </message>
    <message>
        <source>add a light</source>
        <translation>añadir una luz</translation>
    </message>
    <message>
        <source>remove a light</source>
        <translation>quitar una luz</translation>
    </message>
    <message>
        <source>colour of a light</source>
        <translation>color de una luz</translation>
    </message>
    <message>
        <source>How soft its shadows are: half the angle of the cone that the light comes from.</source>
        <translation>Lo suaves que son sus sombras: la mitad del ángulo del cono del que viene la luz.</translation>
    </message>
    <message>
        <source>softness of a light</source>
        <translation>suavidad de una luz</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Place to the patient&apos;s left [mm]</source>
        <translation>Posición hacia la izquierda del paciente [mm]</translation>
    </message>
    <message>
        <source>Place to the back [mm]</source>
        <translation>Posición hacia atrás [mm]</translation>
    </message>
    <message>
        <source>Place to the head [mm]</source>
        <translation>Posición hacia la cabeza [mm]</translation>
    </message>
</context>
<context>
    <name>varimarch::LoadController</name>
    <message>
        <source>There is not enough memory for this volume.</source>
        <translation>No hay memoria suficiente para este volumen.</translation>
    </message>
    <message>
        <source>open a segmentation</source>
        <translation>abrir una segmentación</translation>
    </message>
    <message>
        <source>rectify slices</source>
        <translation>rectificar los cortes</translation>
    </message>
    <message>
        <source>show slices as scanned</source>
        <translation>cortes como se adquirieron</translation>
    </message>
    <message>
        <source>At most %1 scans are drawn at once: remove one of them, and add the scan again</source>
        <translation>Se dibujan como máximo %1 estudios a la vez: quite uno de ellos y añada el estudio de nuevo</translation>
    </message>
    <message>
        <source>add a scan</source>
        <translation>añadir un estudio</translation>
    </message>
</context>
<context>
    <name>varimarch::LookPanel</name>
    <message>
        <source>Preset</source>
        <translation>Preajuste</translation>
    </message>
    <message>
        <source>choose %1</source>
        <translation>elegir %1</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>UH</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>%1, edited</source>
        <translation>%1, editado</translation>
    </message>
    <message>
        <source>custom look</source>
        <translation>aspecto propio</translation>
    </message>
    <message>
        <source>Load a look</source>
        <translation>Cargar un aspecto</translation>
    </message>
    <message numerus="yes">
        <source>The file holds %n looks:</source>
        <translation>
            <numerusform>El archivo contiene %n aspecto:</numerusform>
            <numerusform>El archivo contiene %n aspectos:</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the look</source>
        <translation>Guardar el aspecto</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>cargar %1</translation>
    </message>
    <message>
        <source>All looks (%1)</source>
        <translation>Todos los aspectos (%1)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Colour maps for any kind of colour vision; the opacity curve stays as it is</source>
        <translation>Mapas de color para toda visión del color; la curva de opacidad no cambia</translation>
    </message>
    <message>
        <source>colour map %1</source>
        <translation>mapa de color %1</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Cargar…</translation>
    </message>
    <message>
        <source>Loads a look from a file</source>
        <translation>Carga un aspecto de un archivo</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Saves the look in a file</source>
        <translation>Guarda el aspecto en un archivo</translation>
    </message>
    <message>
        <source>The histogram is of %1 of %2 times</source>
        <translation>El histograma cuenta %1 de %2 tiempos</translation>
    </message>
</context>
<context>
    <name>varimarch::MainWindow</name>
    <message>
        <source>Varimarch, not for diagnostic use</source>
        <translation>Varimarch, no apto para diagnóstico</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sa&amp;lir</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Suggested look</source>
        <translation>Aspecto &amp;sugerido</translation>
    </message>
    <message>
        <source>suggested look</source>
        <translation>aspecto sugerido</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Cut away</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Calidad</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Open a scan, or drop one here</source>
        <translation>Abra un estudio o suéltelo aquí</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
    <message>
        <source>Graphics card</source>
        <translation>Tarjeta gráfica</translation>
    </message>
    <message>
        <source>The graphics card was reset, and the image is drawn anew; nothing is lost.</source>
        <translation>La tarjeta gráfica se reinició y la imagen se dibuja de nuevo; no se ha perdido nada.</translation>
    </message>
    <message>
        <source>The graphics card was reset again before it had drawn an image; save the session and start the program again, with another driver, or with LIBGL_ALWAYS_SOFTWARE=1 to draw without the card.</source>
        <translation>La tarjeta gráfica se reinició otra vez antes de dibujar una imagen; guarde la sesión e inicie el programa de nuevo, con otro controlador, o con LIBGL_ALWAYS_SOFTWARE=1 para dibujar sin la tarjeta.</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>&amp;Restablecer la disposición</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Luces</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volúmenes</translation>
    </message>
    <message>
        <source>Registered; compare the volumes in the slices before you trust it</source>
        <translation>Registrado; compare los volúmenes en los cortes antes de fiarse</translation>
    </message>
    <message>
        <source>Axial slice</source>
        <translation>Corte axial</translation>
    </message>
    <message>
        <source>Coronal slice</source>
        <translation>Corte coronal</translation>
    </message>
    <message>
        <source>Sagittal slice</source>
        <translation>Corte sagital</translation>
    </message>
    <message>
        <source>Along the curve</source>
        <translation>A lo largo de la curva</translation>
    </message>
    <message>
        <source>Titles of panels</source>
        <translation>Títulos de los paneles</translation>
    </message>
</context>
<context>
    <name>varimarch::MeasuresPanel</name>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Remove all</source>
        <translation>Eliminar todo</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>renombrar</translation>
    </message>
    <message>
        <source>remove a measurement</source>
        <translation>eliminar una medición</translation>
    </message>
    <message>
        <source>remove all measurements</source>
        <translation>eliminar todas las mediciones</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Ir</translation>
    </message>
    <message>
        <source>Choose a measurement above, then drag in the volume or in a slice. Points can be dragged later. Double-click a name to change it, or a value to go there.</source>
        <translation>Elija arriba una medición y arrastre en el volumen o en un corte. Los puntos se pueden mover después. Haga doble clic en un nombre para cambiarlo, o en un valor para ir allí.</translation>
    </message>
    <message>
        <source>%1; the box shows or hides it</source>
        <translation>%1; la casilla la muestra u oculta</translation>
    </message>
    <message>
        <source>show a measurement</source>
        <translation>mostrar una medición</translation>
    </message>
    <message>
        <source>hide a measurement</source>
        <translation>ocultar una medición</translation>
    </message>
    <message>
        <source>go to a measurement</source>
        <translation>ir a una medición</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Guardar las mediciones</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>No se puede guardar</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>DICOM structured report (*.dcm)</source>
        <translation>Informe estructurado DICOM (*.dcm)</translation>
    </message>
</context>
<context>
    <name>varimarch::NodePopover</name>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Punto medio</translation>
    </message>
    <message>
        <source>Position where the curve is halfway to the next point</source>
        <translation>Posición en la que la curva está a medio camino del punto siguiente</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Nitidez</translation>
    </message>
    <message>
        <source>0 is a straight line to the next point, 1 is a step</source>
        <translation>0 es una recta hasta el punto siguiente, 1 un escalón</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
</context>
<context>
    <name>varimarch::OpenActions</name>
    <message>
        <source>Volumes (%1)</source>
        <translation>Volúmenes (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation>Cargando %1</translation>
    </message>
    <message>
        <source>A coarse copy is shown until the volume has been read for the first time</source>
        <translation>Se muestra una copia aproximada hasta que el volumen se haya leído por primera vez</translation>
    </message>
    <message>
        <source>Loading was cancelled</source>
        <translation>Se canceló la carga</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a &amp;folder…</source>
        <translation>Abrir una &amp;carpeta…</translation>
    </message>
    <message>
        <source>Open a ra&amp;w file…</source>
        <translation>Abrir un archivo &amp;sin cabecera…</translation>
    </message>
    <message>
        <source>Open fi&amp;les as times…</source>
        <translation>Abrir archivos &amp;de varios tiempos…</translation>
    </message>
    <message>
        <source>&amp;Kinds of volume in the series</source>
        <translation>Tipos de volumen de la serie</translation>
    </message>
    <message>
        <source>A&amp;dd a scan…</source>
        <translation>A&amp;ñadir un estudio…</translation>
    </message>
    <message>
        <source>Open a se&amp;gmentation…</source>
        <translation>Abrir una segmen&amp;tación…</translation>
    </message>
    <message>
        <source>&amp;Ask for a scan at start</source>
        <translation>&amp;Preguntar por un estudio al iniciar</translation>
    </message>
    <message>
        <source>Memor&amp;y for volumes</source>
        <translation>Memoria para &amp;volúmenes</translation>
    </message>
    <message>
        <source>&amp;All of the computer&apos;s</source>
        <translation>&amp;Toda la del equipo</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>The next volume is read within this memory</source>
        <translation>El próximo volumen se leerá dentro de esta memoria</translation>
    </message>
    <message>
        <source>There is no file to open: its name is empty.</source>
        <translation>No hay ningún fichero que abrir: su nombre está vacío.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not answer: its disk or the network may be gone. Try again later.</source>
        <translation>«%1» no responde: quizá no estén disponibles su disco o la red. Inténtelo más tarde.</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Restore your session?</source>
        <translation>El programa terminó de forma inesperada la última vez. ¿Restaurar la sesión?</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Abrir un volumen</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Abrir una carpeta de archivos DICOM</translation>
    </message>
    <message>
        <source>Open files as times: choose one of the files whose names differ in a number</source>
        <translation>Abrir archivos de varios tiempos: elija uno de los archivos cuyos nombres difieren en un número</translation>
    </message>
    <message>
        <source>Open a raw file</source>
        <translation>Abrir un archivo sin cabecera</translation>
    </message>
    <message>
        <source>Add a scan</source>
        <translation>Añadir un estudio</translation>
    </message>
    <message>
        <source>Where is the scan to draw over the one that is shown?</source>
        <translation>¿Dónde está el estudio que se dibujará sobre el mostrado?</translation>
    </message>
    <message>
        <source>In a file…</source>
        <translation>En un archivo…</translation>
    </message>
    <message>
        <source>In a folder of DICOM files…</source>
        <translation>En una carpeta de archivos DICOM…</translation>
    </message>
    <message>
        <source>Open a segmentation of this scan</source>
        <translation>Abrir una segmentación de este estudio</translation>
    </message>
    <message>
        <source>This file may be a segmentation of the scan that is shown: it lies in the same place, and has %1 different whole values. Show it as segments of the scan?</source>
        <translation>Este archivo puede ser una segmentación del estudio mostrado: está en el mismo lugar y tiene %1 valores enteros distintos. ¿Mostrarlo como segmentos del estudio?</translation>
    </message>
    <message>
        <source>Show as segments</source>
        <translation>Mostrar como segmentos</translation>
    </message>
    <message>
        <source>Open as a scan</source>
        <translation>Abrir como estudio</translation>
    </message>
    <message>
        <source>Beside the scan the folder holds a segmentation. Show its segments?</source>
        <translation>Junto al estudio, la carpeta contiene una segmentación. ¿Mostrar sus segmentos?</translation>
    </message>
    <message>
        <source>Look &quot;%1&quot;: %2. Press R to restore it.</source>
        <translation>Aspecto «%1»: %2. Pulse R para restaurarlo.</translation>
    </message>
    <message>
        <source>Added %1; the look panels now change it</source>
        <translation>Se añadió %1; los paneles de aspecto cambian ahora este volumen</translation>
    </message>
    <message>
        <source>The two scans have different frames of reference: they may not fit on each other. Check their place in the slices, and move or register the added one.</source>
        <translation>Los dos estudios tienen sistemas de referencia distintos: puede que no coincidan. Compruebe su posición en los cortes y mueva o registre el añadido.</translation>
    </message>
    <message>
        <source>The files do not say whether the two scans are in the same space. They are placed by their coordinates: check that in the slices, and move or register the added one.</source>
        <translation>Los archivos no dicen si los dos estudios están en el mismo espacio. Se colocan según sus coordenadas: compruébelo en los cortes y mueva o registre el añadido.</translation>
    </message>
    <message>
        <source>Segments: %1</source>
        <translation>Segmentos: %1</translation>
    </message>
    <message>
        <source>Cannot open</source>
        <translation>No se puede abrir</translation>
    </message>
</context>
<context>
    <name>varimarch::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Add this look</source>
        <translation>Añadir este aspecto</translation>
    </message>
    <message>
        <source>Adds the current look to this list</source>
        <translation>Añade el aspecto actual a esta lista</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Removes one of your own looks from this list</source>
        <translation>Quita un aspecto propio de esta lista</translation>
    </message>
    <message>
        <source>Your own look: F2 renames it, Delete removes it</source>
        <translation>Propio: F2 lo renombra, Supr lo elimina</translation>
    </message>
    <message>
        <source>choose %1</source>
        <translation>elegir %1</translation>
    </message>
    <message>
        <source>Remove a preset</source>
        <translation>Eliminar un preajuste</translation>
    </message>
    <message>
        <source>Remove the preset %1? This cannot be undone.</source>
        <translation>¿Eliminar el preajuste %1? Esto no se puede deshacer.</translation>
    </message>
    <message>
        <source>For other kinds of scans (%1)</source>
        <translation>Para otros tipos de estudios (%1)</translation>
    </message>
</context>
<context>
    <name>varimarch::QualityPanel</name>
    <message>
        <source>Largest error</source>
        <translation>Error máximo</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rápido</translation>
    </message>
    <message>
        <source>Error at most</source>
        <translation>Error como máximo</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>calidad</translation>
    </message>
    <message>
        <source>1/%1 of full brightness</source>
        <translation>1/%1 del brillo máximo</translation>
    </message>
    <message>
        <source>Promise the error</source>
        <translation>Prometer el error</translation>
    </message>
    <message>
        <source>Otherwise all steps are as long as the spacing of the voxels suggests</source>
        <translation>Si no, todos los pasos miden lo que sugiere la distancia entre vóxeles</translation>
    </message>
    <message>
        <source>promise of the error</source>
        <translation>promesa del error</translation>
    </message>
    <message>
        <source>A ray ends where less than this part of the light behind it is left</source>
        <translation>Un rayo termina donde queda menos de esta parte de la luz que hay detrás</translation>
    </message>
    <message>
        <source>end of rays</source>
        <translation>final de los rayos</translation>
    </message>
    <message>
        <source>Rays end at</source>
        <translation>Los rayos acaban en</translation>
    </message>
    <message>
        <source>None: voxels are boxes</source>
        <translation>Ninguna: los vóxeles son cajas</translation>
    </message>
    <message>
        <source>The values as they were measured</source>
        <translation>Los valores tal como se midieron</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>The fastest</source>
        <translation>La más rápida</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>Cúbica</translation>
    </message>
    <message>
        <source>A spline: edges have no staircases</source>
        <translation>Un spline: los bordes no tienen escalones</translation>
    </message>
    <message>
        <source>interpolation</source>
        <translation>interpolación</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Inicio aleatorio</translation>
    </message>
    <message>
        <source>Turns the rings that long steps leave into fine grain</source>
        <translation>Convierte los anillos de los pasos largos en un grano fino</translation>
    </message>
    <message>
        <source>jitter</source>
        <translation>inicio aleatorio</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolación</translation>
    </message>
    <message>
        <source>not promised</source>
        <translation>sin prometer</translation>
    </message>
    <message>
        <source>Read only what the image needs</source>
        <translation>Leer solo lo que la imagen necesita</translation>
    </message>
    <message>
        <source>Coarse voxels stay where they change the image by less than half of the error</source>
        <translation>Los vóxeles de baja resolución se mantienen donde cambian la imagen en menos de la mitad del error</translation>
    </message>
    <message>
        <source>what is read</source>
        <translation>lo que se lee</translation>
    </message>
</context>
<context>
    <name>varimarch::RawForm</name>
    <message>
        <source>Layout of %1</source>
        <translation>Formato de %1</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Filas</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>little-endian</source>
        <translation>little-endian (byte menor primero)</translation>
    </message>
    <message>
        <source>big-endian</source>
        <translation>big-endian (byte mayor primero)</translation>
    </message>
    <message>
        <source>Bytes before the first voxel</source>
        <translation>Bytes antes del primer vóxel</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Byte order</source>
        <translation>Orden de bytes</translation>
    </message>
    <message>
        <source>Header bytes</source>
        <translation>Bytes de cabecera</translation>
    </message>
    <message>
        <source>Spacing [mm]</source>
        <translation>Espaciado [mm]</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Skip them as a header</source>
        <translation>Saltarlos como cabecera</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>The file is compressed, so its size can only be checked when it is read.</source>
        <translation>El archivo está comprimido; su tamaño solo se puede comprobar al leerlo.</translation>
    </message>
    <message>
        <source>The layout fits: the file has the %1 bytes that it needs.</source>
        <translation>Encaja: el archivo tiene los %1 bytes que esto necesita.</translation>
    </message>
    <message>
        <source>The file has %1 bytes more than this layout needs.</source>
        <translation>El archivo tiene %1 bytes más de los que esto necesita.</translation>
    </message>
    <message>
        <source>The layout does not fit: the file has %1 bytes less than it needs.</source>
        <translation>No encaja: el archivo tiene %1 bytes menos de los que esto necesita.</translation>
    </message>
    <message>
        <source>The file ends before this slice</source>
        <translation>El archivo termina antes de este corte</translation>
    </message>
    <message>
        <source>Distance of columns [mm]</source>
        <translation>Distancia entre columnas [mm]</translation>
    </message>
    <message>
        <source>Distance of rows [mm]</source>
        <translation>Distancia entre filas [mm]</translation>
    </message>
    <message>
        <source>Distance of slices [mm]</source>
        <translation>Distancia entre cortes [mm]</translation>
    </message>
</context>
<context>
    <name>varimarch::RegionEditor</name>
    <message>
        <source>Add a rectangle</source>
        <translation>Añadir un rectángulo</translation>
    </message>
    <message>
        <source>+ Rectangle</source>
        <translation>+ Rectángulo</translation>
    </message>
    <message>
        <source>Add an ellipse</source>
        <translation>Añadir una elipse</translation>
    </message>
    <message>
        <source>+ Ellipse</source>
        <translation>+ Elipse</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Color…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Show all values and gradients</source>
        <translation>Mostrar todos los valores y gradientes</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>add a region</source>
        <translation>añadir una región</translation>
    </message>
    <message>
        <source>delete a region</source>
        <translation>eliminar una región</translation>
    </message>
    <message>
        <source>colour of a region</source>
        <translation>color de una región</translation>
    </message>
    <message>
        <source>resize a region</source>
        <translation>cambiar el tamaño de una región</translation>
    </message>
    <message>
        <source>move a region</source>
        <translation>mover una región</translation>
    </message>
    <message>
        <source>Add a rectangle here</source>
        <translation>Añadir aquí un rectángulo</translation>
    </message>
    <message>
        <source>Add an ellipse here</source>
        <translation>Añadir aquí una elipse</translation>
    </message>
    <message>
        <source>Regions of value and gradient</source>
        <translation>Regiones de valor y gradiente</translation>
    </message>
    <message>
        <source>%1 %2, gradient %3 per mm: %4 voxels</source>
        <translation>%1 %2, gradiente %3 por mm: %4 vóxeles</translation>
    </message>
</context>
<context>
    <name>varimarch::RegionsBox</name>
    <message>
        <source>Regions of value and gradient</source>
        <translation>Regiones de valor y gradiente</translation>
    </message>
    <message>
        <source>Rectangles and ellipses over the values and their gradients, instead of the curves</source>
        <translation>Rectángulos y elipses sobre los valores y sus gradientes, en lugar de las curvas</translation>
    </message>
    <message>
        <source>opacity of a region</source>
        <translation>opacidad de una región</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>soft edge of a region</source>
        <translation>borde suave de una región</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Borde suave</translation>
    </message>
    <message>
        <source>switch off regions</source>
        <translation>desactivar las regiones</translation>
    </message>
    <message>
        <source>switch on regions</source>
        <translation>activar las regiones</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>UH</translation>
    </message>
</context>
<context>
    <name>varimarch::RemoteControl</name>
    <message>
        <source>look of a script</source>
        <translation>aspecto de un script</translation>
    </message>
</context>
<context>
    <name>varimarch::SaveActions</name>
    <message>
        <source>&amp;Save the session…</source>
        <translation>&amp;Guardar la sesión…</translation>
    </message>
    <message>
        <source>Varimarch</source>
        <translation>Varimarch</translation>
    </message>
    <message>
        <source>Your measurements, cuts, look and segments are not saved. Save the session?</source>
        <translation>Sus medidas, cortes, aspecto y segmentos no están guardados. ¿Guardar la sesión?</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>No se puede guardar</translation>
    </message>
    <message>
        <source>This scan was fetched from an archive and is deleted at the end, so a session could not find it again. Fetch it with &quot;Keep in…&quot; first.</source>
        <translation>Este estudio procede de un archivo y se borra al final; una sesión no podría encontrarlo. Tráigalo primero con «Conservar en…».</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Guardar la sesión</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sesiones (*.json)</translation>
    </message>
    <message>
        <source>Segmentation of 3D Slicer (*.seg.nrrd)</source>
        <translation>Segmentación de 3D Slicer (*.seg.nrrd)</translation>
    </message>
    <message>
        <source>NIfTI (*.nii.gz)</source>
        <translation>NIfTI (*.nii.gz)</translation>
    </message>
    <message>
        <source>DICOM segmentation (*.dcm)</source>
        <translation>Segmentación DICOM (*.dcm)</translation>
    </message>
    <message>
        <source>Save the segmentation</source>
        <translation>Guardar la segmentación</translation>
    </message>
    <message>
        <source>save the segmentation</source>
        <translation>guardar la segmentación</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
</context>
<context>
    <name>varimarch::ScanLists</name>
    <message>
        <source>&amp;Recent scans</source>
        <translation>Estudios &amp;recientes</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Vaciar la lista</translation>
    </message>
    <message>
        <source>St&amp;udy list…</source>
        <translation>Lista de est&amp;udios…</translation>
    </message>
    <message>
        <source>Arc&amp;hive (PACS)…</source>
        <translation>Arc&amp;hivo de imágenes (PACS)…</translation>
    </message>
    <message>
        <source>DICOM attri&amp;butes…</source>
        <translation>Atri&amp;butos DICOM…</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentEditingBox</name>
    <message>
        <source>Draw segments</source>
        <translation>Dibujar segmentos</translation>
    </message>
    <message>
        <source>New segment</source>
        <translation>Segmento nuevo</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segmento %1</translation>
    </message>
    <message>
        <source>new segment</source>
        <translation>segmento nuevo</translation>
    </message>
    <message>
        <source>Nothing has changed: the value there is outside the range, or no voxels are left.</source>
        <translation>Nada ha cambiado: el valor en ese punto está fuera del intervalo o no quedan vóxeles.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Apagado</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Click in a slice or in the volume: the connected voxels of these values are added.</source>
        <translation>Haga clic en un corte o en el volumen: se añaden los vóxeles conectados con estos valores.</translation>
    </message>
    <message>
        <source>Drag in a slice to paint.</source>
        <translation>Arrastre en un corte para pintar.</translation>
    </message>
    <message>
        <source>Drag in a slice to erase.</source>
        <translation>Arrastre en un corte para borrar.</translation>
    </message>
    <message>
        <source>Smallest value of a region</source>
        <translation>Valor mínimo de una región</translation>
    </message>
    <message>
        <source>Largest value of a region</source>
        <translation>Valor máximo de una región</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radio del pincel</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Keep the largest part</source>
        <translation>Conservar la parte mayor</translation>
    </message>
    <message>
        <source>Remove parts below</source>
        <translation>Quitar partes menores de</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Suavizar</translation>
    </message>
    <message>
        <source>Save the segmentation…</source>
        <translation>Guardar la segmentación…</translation>
    </message>
    <message>
        <source>Volume of the smallest part that is kept</source>
        <translation>Volumen de la parte más pequeña que se conserva</translation>
    </message>
    <message>
        <source> ml</source>
        <translation> ml</translation>
    </message>
    <message>
        <source>Width of the smoothing</source>
        <translation>Anchura del suavizado</translation>
    </message>
    <message>
        <source>Working on the segment</source>
        <translation>Trabajando en el segmento</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentEditor</name>
    <message>
        <source>add a region</source>
        <translation>añadir una región</translation>
    </message>
    <message>
        <source>erase</source>
        <translation>borrar</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>pintar</translation>
    </message>
    <message>
        <source>keep the largest part</source>
        <translation>conservar la parte mayor</translation>
    </message>
    <message>
        <source>remove small parts</source>
        <translation>quitar partes pequeñas</translation>
    </message>
    <message>
        <source>smooth a segment</source>
        <translation>suavizar un segmento</translation>
    </message>
    <message>
        <source>The segments were changed meanwhile, so this edit was left out.</source>
        <translation>Los segmentos cambiaron mientras tanto, por lo que se omitió esta edición.</translation>
    </message>
</context>
<context>
    <name>varimarch::SegmentsPanel</name>
    <message>
        <source>A segmentation of this scan colours its regions: a DICOM segmentation, a segmentation of 3D Slicer, or a label map in NRRD, NIfTI or another format.</source>
        <translation>Una segmentación de este estudio colorea sus regiones: una segmentación DICOM, una segmentación de 3D Slicer o un mapa de etiquetas en NRRD, NIfTI u otro formato.</translation>
    </message>
    <message>
        <source>Open a segmentation…</source>
        <translation>Abrir una segmentación…</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todos</translation>
    </message>
    <message>
        <source>Hide all</source>
        <translation>Ocultar todos</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Color…</translation>
    </message>
    <message>
        <source>Opacity of the selected segments</source>
        <translation>Opacidad de los segmentos seleccionados</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Guardar como CSV…</translation>
    </message>
    <message>
        <source>Close the segmentation</source>
        <translation>Cerrar la segmentación</translation>
    </message>
    <message>
        <source>close the segmentation</source>
        <translation>cerrar la segmentación</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>UH</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segmento</translation>
    </message>
    <message>
        <source>Volume
ml</source>
        <translation>Volumen
ml</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Mín</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Máx</translation>
    </message>
    <message>
        <source>The volume cannot show segments, since its voxels have several values.</source>
        <translation>El volumen no puede mostrar segmentos, porque sus vóxeles tienen varios valores.</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>renombrar</translation>
    </message>
    <message>
        <source>show a segment</source>
        <translation>mostrar un segmento</translation>
    </message>
    <message>
        <source>hide a segment</source>
        <translation>ocultar un segmento</translation>
    </message>
    <message>
        <source>show all segments</source>
        <translation>mostrar todos los segmentos</translation>
    </message>
    <message>
        <source>hide all segments</source>
        <translation>ocultar todos los segmentos</translation>
    </message>
    <message>
        <source>opacity of segments</source>
        <translation>opacidad de segmentos</translation>
    </message>
    <message>
        <source>colour of a segment</source>
        <translation>color de un segmento</translation>
    </message>
    <message>
        <source>Save the statistics</source>
        <translation>Guardar la estadística</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>Cannot save</source>
        <translation>No se puede guardar</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>The volume shows segments only with the blend mode Composite.</source>
        <translation>El volumen solo muestra segmentos con el modo de mezcla «Composición».</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Segmentos</translation>
    </message>
    <message>
        <source>Segments of %1</source>
        <translation>Segmentos de %1</translation>
    </message>
    <message>
        <source>The volume shows at most %1 scans and segmentations together; not all fit.</source>
        <translation>El volumen muestra como máximo %1 estudios y segmentaciones juntos; no caben todos.</translation>
    </message>
</context>
<context>
    <name>varimarch::SendDialog</name>
    <message>
        <source>Directions and measurements</source>
        <translation>Direcciones y mediciones</translation>
    </message>
    <message>
        <source>With the patient and the study of the scan</source>
        <translation>Con el paciente y el estudio</translation>
    </message>
    <message>
        <source>Send the image to an archive</source>
        <translation>Enviar la imagen a un archivo PACS</translation>
    </message>
    <message>
        <source>Otherwise the image names nobody, and the archive lists it as a study of its own. With several scans it is the one chosen in the panel Volumes.</source>
        <translation>Si no, la imagen no nombra a nadie y el archivo la muestra como un estudio propio. Si hay varios estudios, es el elegido en el panel Volúmenes.</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Enviar</translation>
    </message>
    <message>
        <source>Add an archive first.</source>
        <translation>Añada primero un archivo.</translation>
    </message>
    <message>
        <source>The archive has stored the image.</source>
        <translation>El archivo ha guardado la imagen.</translation>
    </message>
    <message>
        <source>Sending…</source>
        <translation>Enviando…</translation>
    </message>
    <message>
        <source>The measurements too, as a structured report</source>
        <translation>También las mediciones, como informe estructurado</translation>
    </message>
</context>
<context>
    <name>varimarch::SeriesPicker</name>
    <message>
        <source>%1
%2, images: %3</source>
        <translation>%1
%2, imágenes: %3</translation>
    </message>
    <message>
        <source>No description</source>
        <translation>Sin descripción</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Elegir una serie</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Series</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Found %1 series.</source>
        <translation>Se encontraron %1 series.</translation>
    </message>
</context>
<context>
    <name>varimarch::ShadingBox</name>
    <message>
        <source>Soft</source>
        <translation>Suave</translation>
    </message>
    <message>
        <source>Clinical</source>
        <translation>Clínica</translation>
    </message>
    <message>
        <source>Glossy</source>
        <translation>Brillante</translation>
    </message>
    <message>
        <source>Flat: unshaded colours</source>
        <translation>Plana: colores sin sombreado</translation>
    </message>
    <message>
        <source>Light and shading</source>
        <translation>Luz y sombreado</translation>
    </message>
    <message>
        <source>shading</source>
        <translation>sombreado</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Ambiente</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Difusa</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Especular</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Exponente</translation>
    </message>
    <message>
        <source>light</source>
        <translation>luz</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizada</translation>
    </message>
    <message>
        <source>Gradient below which light other than ambient weakens, so that noise in homogeneous material does not glitter</source>
        <translation>Gradiente por debajo del cual la luz no ambiental se debilita, para que el ruido del material homogéneo no brille</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>amortiguación</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source> HU/mm</source>
        <translation> UH/mm</translation>
    </message>
    <message>
        <source> per mm</source>
        <translation> por mm</translation>
    </message>
</context>
<context>
    <name>varimarch::SlabBar</name>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Blend mode of the slab</source>
        <translation>Modo de mezcla del corte grueso</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Thickness of the slices</source>
        <translation>Grosor de los cortes</translation>
    </message>
    <message>
        <source>A slab shows the largest, the smallest or the mean value over its thickness</source>
        <translation>Los cortes gruesos muestran el valor mayor, el menor o la media</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>slab</source>
        <translation>grosor del corte</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>Show axial, coronal and sagittal slices again</source>
        <translation>Mostrar de nuevo los cortes axial, coronal y sagital</translation>
    </message>
    <message>
        <source>straighten the slices</source>
        <translation>enderezar los cortes</translation>
    </message>
</context>
<context>
    <name>varimarch::SliceView</name>
    <message>
        <source>window and level</source>
        <translation>ventana y nivel</translation>
    </message>
    <message>
        <source>move the crosshair</source>
        <translation>mover la cruz</translation>
    </message>
    <message>
        <source>turn the slices</source>
        <translation>girar los cortes</translation>
    </message>
</context>
<context>
    <name>varimarch::StartPage</name>
    <message>
        <source>Open a scan, or drop one on this window</source>
        <translation>Abra un estudio, o suéltelo en esta ventana</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir un archivo…</translation>
    </message>
    <message>
        <source>NIfTI, NRRD, MetaImage, a ZIP of a CD, a session …</source>
        <translation>NIfTI, NRRD, MetaImage, ZIP de un CD, una sesión …</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>Abrir una carpeta…</translation>
    </message>
    <message>
        <source>A CD, or the slices of a DICOM series</source>
        <translation>Un CD, o los cortes de una serie DICOM</translation>
    </message>
    <message>
        <source>Recent scans</source>
        <translation>Estudios recientes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Head CT</source>
        <translation>TC de una cabeza</translation>
    </message>
    <message>
        <source>From the package invesalius-examples</source>
        <translation>Del paquete invesalius-examples</translation>
    </message>
    <message>
        <source>Phantom of a torso</source>
        <translation>Fantoma de un torso</translation>
    </message>
    <message>
        <source>Computed, with bones, lungs and vessels</source>
        <translation>Calculado, con huesos, pulmones y vasos</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Recorrido de dos minutos</translation>
    </message>
    <message>
        <source>What is where, on the phantom</source>
        <translation>Dónde está cada cosa, con el fantoma</translation>
    </message>
</context>
<context>
    <name>varimarch::StudyListWindow</name>
    <message>
        <source>No name</source>
        <translation>Sin nombre</translation>
    </message>
    <message>
        <source>Study without description</source>
        <translation>Estudio sin descripción</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Study list</source>
        <translation>Lista de estudios</translation>
    </message>
    <message>
        <source>Search for names, numbers, dates and descriptions</source>
        <translation>Buscar nombres, números, fechas y descripciones</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Estudios</translation>
    </message>
    <message>
        <source>Patient, study, series</source>
        <translation>Paciente, estudio, serie</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalidad</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Add a folder…</source>
        <translation>Añadir una carpeta…</translation>
    </message>
    <message>
        <source>Find changes</source>
        <translation>Buscar cambios</translation>
    </message>
    <message>
        <source>Reads files of the folders that are new or have changed</source>
        <translation>Lee los ficheros nuevos o cambiados de las carpetas</translation>
    </message>
    <message>
        <source>Remove a folder</source>
        <translation>Quitar una carpeta</translation>
    </message>
    <message>
        <source>Remove the whole list</source>
        <translation>Eliminar toda la lista</translation>
    </message>
    <message>
        <source>Deletes all that the list knows of patients; scans stay</source>
        <translation>Borra todo lo que la lista sabe de los pacientes; los estudios se quedan</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Reading the folders…</source>
        <translation>Leyendo las carpetas…</translation>
    </message>
    <message>
        <source>Add a folder with DICOM files. The list stays on this computer and is yours only.</source>
        <translation>Añada una carpeta con ficheros DICOM. La lista se queda en este ordenador y es solo suya.</translation>
    </message>
    <message>
        <source>Series: %1. A double-click opens one.</source>
        <translation>Series: %1. Un doble clic abre una.</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>Añadir una carpeta</translation>
    </message>
    <message>
        <source>Delete all that the list knows of folders and patients? The scans themselves stay.</source>
        <translation>¿Borrar todo lo que la lista sabe de carpetas y pacientes? Los estudios mismos se quedan.</translation>
    </message>
</context>
<context>
    <name>varimarch::TagsWindow</name>
    <message>
        <source>Reading the attributes…</source>
        <translation>Leyendo los atributos…</translation>
    </message>
    <message>
        <source>DICOM attributes</source>
        <translation>Atributos DICOM</translation>
    </message>
    <message>
        <source>Search in tags, names and values</source>
        <translation>Buscar en etiquetas, nombres y valores</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Attributes</source>
        <translation>Atributos</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copies the selected attributes, or all that are shown (Ctrl+C)</source>
        <translation>Copia los atributos elegidos, o todos los mostrados (Ctrl+C)</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> de %1</translation>
    </message>
    <message>
        <source>%1: attributes: %2</source>
        <translation>%1: atributos: %2</translation>
    </message>
</context>
<context>
    <name>varimarch::TimeBar</name>
    <message>
        <source>Speed of the times</source>
        <translation>Velocidad de los tiempos</translation>
    </message>
    <message>
        <source>&amp;Play the times</source>
        <translation>Re&amp;producir los tiempos</translation>
    </message>
    <message>
        <source>P&amp;revious time</source>
        <translation>Tiempo an&amp;terior</translation>
    </message>
    <message>
        <source>&amp;Next time</source>
        <translation>Tiempo &amp;siguiente</translation>
    </message>
    <message>
        <source>Repe&amp;at</source>
        <translation>Repe&amp;tir</translation>
    </message>
    <message>
        <source>&amp;Curve at the crosshair</source>
        <translation>&amp;Curva en la cruz</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>As acquired</source>
        <translation>Como se adquirieron</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 por segundo</translation>
    </message>
    <message>
        <source>%1, loading…</source>
        <translation>%1, cargando…</translation>
    </message>
    <message>
        <source>play</source>
        <translation>reproducir</translation>
    </message>
</context>
<context>
    <name>varimarch::TimeCurve</name>
    <message>
        <source>Value over time at the crosshair</source>
        <translation>Valor en la cruz a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Copiar como CSV</translation>
    </message>
    <message>
        <source>Ctrl+C copies the values as CSV</source>
        <translation>Ctrl+C copia los valores como CSV</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>tiempo [s]</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>%1 at the crosshair, %2 of %3 times</source>
        <translation>%1 en la cruz, %2 de %3 tiempos</translation>
    </message>
</context>
<context>
    <name>varimarch::ToolMenu</name>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Herramientas</translation>
    </message>
    <message>
        <source>&amp;Mark a key image</source>
        <translation>&amp;Marcar una imagen clave</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>&amp;Girar</translation>
    </message>
    <message>
        <source>Drag to rotate the volume</source>
        <translation>Arrastre para girar el volumen</translation>
    </message>
    <message>
        <source>Wa&amp;lk</source>
        <translation>Cam&amp;inar</translation>
    </message>
    <message>
        <source>Walk through the volume: W, A, S, D or arrow keys, E and Q; drag to look around</source>
        <translation>Caminar por el volumen: W, A, S, D o flechas, E y Q; arrastre para mirar alrededor</translation>
    </message>
    <message>
        <source>&amp;Window/Level</source>
        <translation>&amp;Ventana/nivel</translation>
    </message>
    <message>
        <source>Drag sideways for the window, up and down for the level; or drag with Ctrl</source>
        <translation>Arrastre en horizontal para la ventana, en vertical para el nivel; también Ctrl y arrastrar</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Distancia</translation>
    </message>
    <message>
        <source>Drag from one point to another</source>
        <translation>Arrastre de un punto a otro</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>Á&amp;ngulo</translation>
    </message>
    <message>
        <source>Drag from the end of one arm to the vertex, then press at the end of the other</source>
        <translation>Arrastre del extremo de un lado al vértice y pulse en el extremo del otro</translation>
    </message>
    <message>
        <source>B&amp;ox</source>
        <translation>Ca&amp;ja</translation>
    </message>
    <message>
        <source>Drag from corner to corner: mean, deviation, volume</source>
        <translation>Arrastre de esquina a esquina: media, desviación, volumen</translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation>&amp;Tijeras</translation>
    </message>
    <message>
        <source>Draw around the part to remove</source>
        <translation>Rodee la parte que se quita</translation>
    </message>
    <message>
        <source>&amp;Keep inside</source>
        <translation>C&amp;onservar el interior</translation>
    </message>
    <message>
        <source>Draw around the part to keep</source>
        <translation>Rodee la parte que se conserva</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Barra de herramientas</translation>
    </message>
    <message>
        <source>Annotate</source>
        <translation>Anotar</translation>
    </message>
    <message>
        <source>Cobb angles, regions, curves, arrows and texts</source>
        <translation>Ángulos de Cobb, regiones, curvas, flechas y textos</translation>
    </message>
    <message>
        <source>Anno&amp;tate</source>
        <translation>&amp;Anotar</translation>
    </message>
    <message>
        <source>&amp;Cobb angle</source>
        <translation>Ángulo de &amp;Cobb</translation>
    </message>
    <message>
        <source>Drag along one line, then another</source>
        <translation>Arrastre a lo largo de una línea y después de otra</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Elipse</translation>
    </message>
    <message>
        <source>Drag across a slice: area, mean, deviation, smallest and largest value</source>
        <translation>Arrastre sobre un corte: área, media, desviación, valor mínimo y máximo</translation>
    </message>
    <message>
        <source>&amp;Freehand region</source>
        <translation>Región a &amp;mano alzada</translation>
    </message>
    <message>
        <source>Draw around a region of a slice: area, mean, deviation, smallest and largest value</source>
        <translation>Dibuje alrededor de una región de un corte: área, media, desviación, valor mínimo y máximo</translation>
    </message>
    <message>
        <source>C&amp;urve</source>
        <translation>C&amp;urva</translation>
    </message>
    <message>
        <source>Click along a vessel or the jaw: its length, and the volume straightened along it</source>
        <translation>Haga clic a lo largo de un vaso o de la mandíbula: su longitud, y el volumen enderezado a lo largo</translation>
    </message>
    <message>
        <source>&amp;Arrow</source>
        <translation>&amp;Flecha</translation>
    </message>
    <message>
        <source>Drag to the thing to show, then type</source>
        <translation>Arrastre hasta lo que quiere mostrar y escriba</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Texto</translation>
    </message>
    <message>
        <source>Click, then type</source>
        <translation>Haga clic y escriba</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;No comparison</source>
        <translation>&amp;Sin comparación</translation>
    </message>
    <message>
        <source>Compare with VTK&apos;s &amp;GPU mapper</source>
        <translation>Comparar con el mapper de G&amp;PU de VTK</translation>
    </message>
    <message>
        <source>Compare with VTK&apos;s CP&amp;U mapper</source>
        <translation>Comparar con el mapper de CP&amp;U de VTK</translation>
    </message>
    <message>
        <source>W&amp;ipe between them</source>
        <translation>Des&amp;lizar entre ambas</translation>
    </message>
    <message>
        <source>Both images in one place, with a divider to drag</source>
        <translation>Ambas imágenes en un lugar, con un divisor que se arrastra</translation>
    </message>
    <message>
        <source>Benc&amp;hmark…</source>
        <translation>Prueba de &amp;rendimiento…</translation>
    </message>
</context>
<context>
    <name>varimarch::Tour</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Terminar el recorrido</translation>
    </message>
    <message>
        <source>Tour: %1 of %2</source>
        <translation>Recorrido: %1 de %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
</context>
<context>
    <name>varimarch::TransferFunctionEditor</name>
    <message>
        <source>Edit numbers…</source>
        <translation>Editar números…</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Color…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Add a point after the selected one</source>
        <translation>Añadir un punto tras el elegido</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Mostrar todos los valores</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Hide the outermost 1 % of the voxels</source>
        <translation>Ocultar el 1 % más extremo de los vóxeles</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
    <message>
        <source>Show the curve</source>
        <translation>Mostrar la curva</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Logarithmic counts</source>
        <translation>Recuentos logarítmicos</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>Enlarge low opacities</source>
        <translation>Ampliar las opacidades bajas</translation>
    </message>
    <message>
        <source>nudge points</source>
        <translation>ajustar puntos</translation>
    </message>
    <message>
        <source>delete points</source>
        <translation>borrar puntos</translation>
    </message>
    <message>
        <source>delete point</source>
        <translation>borrar punto</translation>
    </message>
    <message>
        <source>add point</source>
        <translation>añadir punto</translation>
    </message>
    <message>
        <source>choose colour</source>
        <translation>elegir color</translation>
    </message>
    <message>
        <source>edit point</source>
        <translation>editar punto</translation>
    </message>
    <message>
        <source>Add a point here</source>
        <translation>Añadir un punto aquí</translation>
    </message>
    <message>
        <source>move points</source>
        <translation>mover puntos</translation>
    </message>
    <message>
        <source>move colour</source>
        <translation>mover color</translation>
    </message>
    <message>
        <source>move point</source>
        <translation>mover punto</translation>
    </message>
    <message>
        <source>shift the curve</source>
        <translation>desplazar la curva</translation>
    </message>
    <message>
        <source>add colour</source>
        <translation>añadir color</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Función de transferencia</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>scale the curve</source>
        <translation>escalar la curva</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Bajas</translation>
    </message>
    <message>
        <source>Ask for the colour of a new point</source>
        <translation>Preguntar por el color de un punto nuevo</translation>
    </message>
</context>
<context>
    <name>varimarch::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vista</translation>
    </message>
    <message>
        <source>&amp;Background…</source>
        <translation>&amp;Fondo…</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>Pan&amp;eles</translation>
    </message>
    <message>
        <source>&amp;Anterior</source>
        <translation>&amp;Anterior</translation>
    </message>
    <message>
        <source>&amp;Posterior</source>
        <translation>&amp;Posterior</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Izquierda</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Derecha</translation>
    </message>
    <message>
        <source>&amp;Superior</source>
        <translation>&amp;Superior</translation>
    </message>
    <message>
        <source>&amp;Inferior</source>
        <translation>I&amp;nferior</translation>
    </message>
    <message>
        <source>standard view</source>
        <translation>vista estándar</translation>
    </message>
    <message>
        <source>Parall&amp;el projection</source>
        <translation>Proyección pa&amp;ralela</translation>
    </message>
    <message>
        <source>No perspective: distant objects look as large as near ones</source>
        <translation>Sin perspectiva: lo lejano se ve tan grande como lo cercano</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>proyección</translation>
    </message>
    <message>
        <source>background</source>
        <translation>fondo</translation>
    </message>
    <message>
        <source>&amp;Window of the slices</source>
        <translation>&amp;Ventana de los cortes</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Como en el archivo</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>Or click a slice and press %1</source>
        <translation>O haga clic en un corte y pulse %1</translation>
    </message>
    <message>
        <source>&amp;Volume large</source>
        <translation>Volumen &amp;grande</translation>
    </message>
    <message>
        <source>&amp;Four views alike</source>
        <translation>&amp;Cuatro vistas iguales</translation>
    </message>
    <message>
        <source>Double-click a view to see it alone, and again to see all</source>
        <translation>Doble clic muestra una vista sola; otro, todas</translation>
    </message>
    <message>
        <source>Full s&amp;creen</source>
        <translation>Pantalla co&amp;mpleta</translation>
    </message>
    <message>
        <source>&amp;Window, level and zoom</source>
        <translation>&amp;Ventana, nivel y zoom</translation>
    </message>
    <message>
        <source>&amp;Number of the slice</source>
        <translation>&amp;Número del corte</translation>
    </message>
    <message>
        <source>&amp;Position</source>
        <translation>&amp;Posición</translation>
    </message>
    <message>
        <source>Thickness of the &amp;slab</source>
        <translation>&amp;Grosor del corte</translation>
    </message>
    <message>
        <source>S&amp;cale bar</source>
        <translation>E&amp;scala</translation>
    </message>
    <message>
        <source>&amp;Directions of the patient</source>
        <translation>&amp;Direcciones del paciente</translation>
    </message>
    <message>
        <source>Te&amp;xts over the slices</source>
        <translation>Te&amp;xtos sobre los cortes</translation>
    </message>
    <message>
        <source>&amp;Times</source>
        <translation>&amp;Tiempos</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automática</translation>
    </message>
    <message>
        <source>From the darkest to the brightest values of the scan</source>
        <translation>De los valores más oscuros a los más claros del estudio</translation>
    </message>
</context>
<context>
    <name>varimarch::VolumeView</name>
    <message>
        <source>turn the camera</source>
        <translation>girar la cámara</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
</context>
<context>
    <name>varimarch::VolumesPanel</name>
    <message>
        <source>computed volume</source>
        <translation>volumen calculado</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>Volúmenes</translation>
    </message>
    <message>
        <source>The look panels change the selected volume</source>
        <translation>Los paneles de aspecto cambian el volumen seleccionado</translation>
    </message>
    <message>
        <source>Add a scan…</source>
        <translation>Añadir un estudio…</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Subir</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Opacity of the volume</source>
        <translation>Opacidad del volumen</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Hot</source>
        <translation>Cálido</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Verde</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>In slices</source>
        <translation>En los cortes</translation>
    </message>
    <message>
        <source>opacity of a volume</source>
        <translation>opacidad de un volumen</translation>
    </message>
    <message>
        <source>colours in slices</source>
        <translation>colores en los cortes</translation>
    </message>
    <message>
        <source>Place beside its patient coordinates</source>
        <translation>Posición respecto al paciente</translation>
    </message>
    <message>
        <source>Move to the patient&apos;s left</source>
        <translation>Mover hacia la izquierda del paciente</translation>
    </message>
    <message>
        <source>Move to the back</source>
        <translation>Mover hacia atrás</translation>
    </message>
    <message>
        <source>Move to the head</source>
        <translation>Mover hacia la cabeza</translation>
    </message>
    <message>
        <source>Turn about the axis to the left</source>
        <translation>Girar alrededor del eje hacia la izquierda</translation>
    </message>
    <message>
        <source>Turn about the axis to the back</source>
        <translation>Girar alrededor del eje hacia atrás</translation>
    </message>
    <message>
        <source>Turn about the axis to the head</source>
        <translation>Girar alrededor del eje hacia la cabeza</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Patient coordinates</source>
        <translation>Coordenadas del paciente</translation>
    </message>
    <message>
        <source>patient coordinates</source>
        <translation>coordenadas del paciente</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrar</translation>
    </message>
    <message>
        <source>Finds the place where the volume fits the first one best, as a rigid body</source>
        <translation>Busca la posición en que el volumen encaja mejor sobre el primero, como cuerpo rígido</translation>
    </message>
    <message>
        <source>rename</source>
        <translation>renombrar</translation>
    </message>
    <message>
        <source>show a volume</source>
        <translation>mostrar un volumen</translation>
    </message>
    <message>
        <source>hide a volume</source>
        <translation>ocultar un volumen</translation>
    </message>
    <message>
        <source>move a volume</source>
        <translation>mover un volumen</translation>
    </message>
    <message>
        <source>order of volumes</source>
        <translation>orden de los volúmenes</translation>
    </message>
    <message>
        <source>remove a volume</source>
        <translation>quitar un volumen</translation>
    </message>
    <message>
        <source>Move to the left, to the back, to the head</source>
        <translation>Mover a la izquierda, atrás y a la cabeza</translation>
    </message>
    <message>
        <source>Turn about these axes</source>
        <translation>Girar alrededor de estos ejes</translation>
    </message>
    <message>
        <source>Several volumes are drawn together as composites.</source>
        <translation>Varios volúmenes se dibujan juntos como compuestos.</translation>
    </message>
    <message>
        <source>Registering</source>
        <translation>Registrando</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cannot register</source>
        <translation>No se puede registrar</translation>
    </message>
    <message>
        <source>register a volume</source>
        <translation>registrar un volumen</translation>
    </message>
</context>
<context>
    <name>varimarch::WarningBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Rectify</source>
        <translation>Rectificar</translation>
    </message>
    <message>
        <source>Show as scanned</source>
        <translation>Mostrar como se adquirió</translation>
    </message>
    <message>
        <source>Open all images</source>
        <translation>Abrir todas las imágenes</translation>
    </message>
    <message>
        <source>This image belongs to a series of %1 images.</source>
        <translation>Esta imagen pertenece a una serie de %1 imágenes.</translation>
    </message>
</context>
</TS>
